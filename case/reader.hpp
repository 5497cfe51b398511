// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/overrides.hpp"
#include "case/problems.hpp"

namespace pulvis {

/// Reads and checks a case file, put together with the files it extends, and with the overrides put in. Throws
/// CaseError with all problems of the case, Failure(Exit::bad_input) if one of the files cannot be read.
Case read_case(const std::string& path, const std::vector<Override>& overrides = {});

/// The same for a text; `name` stands for the file in messages, and paths in the case are seen from it.
Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<Override>& overrides = {});

/// Where a key or table of the case is written ("die.toml:14", "--set KEY"), for messages about what only
/// shows when the case is put together; if it is not given, where the nearest table around it is, or the file.
std::string place_of(const Case& c, std::string key);

/// Where these keys, and all in these tables, are written, in short: "die.toml:14, 17 and base.toml:3". What is not
/// given is left out; empty if nothing is.
std::string places_of(const Case& c, const std::vector<std::string>& keys);

/// What a key means: kind, default, range, when it counts; of a table, its keys too. The key may be
/// written as in the reference ("materials.*.density"), as in a case ("materials.steel.density") or by
/// its last part. Throws Failure(Exit::usage) with the nearest key for one that does not exist.
std::string explain(const std::string& key);

/// The reference page of all keys, in Markdown.
std::string keys_reference_markdown();

/// A JSON Schema (2020-12) of case files, for editors.
std::string json_schema();

}  // namespace pulvis
