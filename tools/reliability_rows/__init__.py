# SPDX-License-Identifier: Apache-2.0
"""The rows of tools/reliability, in the order of their imports."""
from .common import ROOT, ROWS, Result  # noqa: F401
from . import kill  # noqa: F401
from .scenes import renew_hashes  # noqa: F401
from . import checks, fuzz, disk, sanitizers  # noqa: F401
