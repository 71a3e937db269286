// The program of libFuzzer. Beside its own options, which begin with one minus sign:
//   --kind=NAME       what the files are; without it, and without another, prints all names
//   --seeds=DIR       writes the kind's seeds there, and its dictionary to DIR.dict, and ends
//   --crashes=DIR     keeps files whose mesh importer crashed in its own process
//   --unguarded       imports meshes in this process, so that a crash there can be looked at
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "fuzz/kind.h"

namespace dockyard {
namespace {

// libFuzzer calls two plain functions: what the first makes of the command line, the second needs.
FuzzKind the_kind;

struct Options {
  std::string kind, seeds;
  MeshFuzzOptions meshes;
};

Options OptionsOf(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&](const std::string& name) {
      return word.rfind(name, 0) == 0 ? word.substr(name.size()) : std::string();
    };
    if (word == "--unguarded") options.meshes.unguarded = true;
    if (word.rfind("--kind=", 0) == 0) options.kind = value("--kind=");
    if (word.rfind("--seeds=", 0) == 0) options.seeds = value("--seeds=");
    if (word.rfind("--crashes=", 0) == 0) options.meshes.crash_dir = value("--crashes=");
  }
  return options;
}

/// As libFuzzer reads it: a string in quotation marks a line, odd bytes as \xAB.
std::string DictionaryText(const std::vector<std::string>& words) {
  std::string text = "# words\n";  // an empty file is an error
  for (const std::string& word : words) {
    text += '"';
    for (const char c : word) {
      char coded[8];
      std::snprintf(coded, sizeof coded, "\\x%02x", static_cast<unsigned char>(c));
      text += c > ' ' && c < '\x7f' && c != '"' && c != '\\' ? std::string(1, c) : coded;
    }
    text += "\"\n";
  }
  return text;
}

void WriteSeeds(const FuzzKind& kind, const std::string& dir) {
  const std::vector<std::string> seeds = kind.seeds();
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    std::ofstream(dir + "/seed_" + std::to_string(i), std::ios::binary) << seeds[i];
  }
  std::ofstream(dir + ".dict") << DictionaryText(kind.words);
}

}  // namespace
}  // namespace dockyard

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace dockyard;
  const Options options = OptionsOf(*argc, *argv);
  for (const NamedKind& named : AllFuzzKinds(options.meshes)) {
    if (options.kind.empty()) std::printf("%s\n", named.name.c_str());
    if (named.name == options.kind) the_kind = named.make();
  }
  if (options.kind.empty()) std::exit(0);
  if (!the_kind.read) {
    std::fprintf(stderr, "--kind: expected a kind, found '%s'\n", options.kind.c_str());
    std::exit(2);
  }
  if (!options.seeds.empty()) {
    WriteSeeds(the_kind, options.seeds);
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dockyard::the_kind.read(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
