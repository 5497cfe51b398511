// SPDX-License-Identifier: Apache-2.0
// Folders of runs, as the report reads them: the input is its files one after the other, each after a line "== NAME".
#include "report/report.hpp"

#include "report/run_data.hpp"
#include "tests/fuzz/scratch.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pulvis::fuzz::Scratch folder;
  const std::string run = folder.file("run");
  std::filesystem::remove_all(run);
  std::filesystem::create_directories(run + "/measures");
  const std::string text = pulvis::fuzz::text_of(data, size);
  static const char* const names[] = {"result.json", "run.json",     "case.toml",
                                      "log.csv",     "measures.csv", "measures/after-fill.json"};
  for (const char* name : names) {
    const std::string head = std::string("== ") + name + "\n";
    const std::size_t at = text.find(head);
    if (at == std::string::npos) continue;
    const std::size_t begin = at + head.size(), end = std::min(text.find("\n== ", begin), text.size());
    folder.write(std::string("run/") + name, text.substr(begin, end - begin));
  }
  pulvis::fuzz::may_refuse([&] { pulvis::report::read_run(run); });
  return 0;
}
