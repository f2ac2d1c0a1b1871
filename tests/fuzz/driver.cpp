// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0

// Runs a fuzz entry without libFuzzer on mutations of its seeds, the same ones every time:
//   <reader>_fuzz [COUNT [FIRST]]   mutations FIRST to FIRST + COUNT - 1, by default 1 to 50000
// A mutation that ends the process is named, so that `<reader>_fuzz 1 NUMBER` under a debugger shows it.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fuzz.h"
#include "mutate.h"

namespace {

using namespace scan_to_path;

char current[64] = "a seed";

void nameMutation(int signal) {
  // Only write() is safe here.
  for (const char* text : {"failed on ", static_cast<const char*>(current), "\n"}) {
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) break;
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(const std::string& input) {
  // A copy of exactly the input's size: the sanitizer sees a read past its end.
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 50000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::signal(SIGABRT, nameMutation);
  std::signal(SIGSEGV, nameMutation);
  std::signal(SIGFPE, nameMutation);
  const auto corpus = fuzz::seeds();
  for (const auto& seed : corpus) run(seed);
  for (std::uint64_t number = first; number < first + count; ++number) {
    std::snprintf(current, sizeof(current), "mutation %llu", static_cast<unsigned long long>(number));
    Random random(number);
    run(fuzz::mutated(corpus, random));
  }
  std::printf("%llu mutations of %zu seeds\n", static_cast<unsigned long long>(count), corpus.size());
  return 0;
}
