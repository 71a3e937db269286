#include "sim/base/shell_word.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace dockyard {
namespace {

/// What a shell makes of the words.
std::string Said(const std::string& words) {
  std::string said;
  FILE* shell = ::popen(("printf '%s\\n' " + words).c_str(), "r");
  for (int c; (c = std::fgetc(shell)) != EOF;) said += static_cast<char>(c);
  ::pclose(shell);
  return said;
}

TEST(ShellWord, IsReadBackByAShell) {
  for (const char* text : {"plain/file-1.yaml", "two words", "it's", "$HOME `ls` \\ \"x\" #", "*",
                           "start.r_m=5", "a\tb", "~", "", "'", "''"}) {
    EXPECT_EQ(Said(ShellWord(text) + " " + ShellWord("next")), text + std::string("\nnext\n"));
  }
}

TEST(CommandText, IsReadBackByAShellWordByWord) {
  EXPECT_EQ(CommandText("build/dockyard", {"replay", "my results", "3"}),
            "build/dockyard replay 'my results' 3");
  EXPECT_EQ(Said(CommandText("'a b'", {"it's", ""})), "a b\nit's\n\n");
}

TEST(ShellWord, LeavesPlainWordsAsTheyAre) {
  EXPECT_EQ(ShellWord("results/yard_2.csv"), "results/yard_2.csv");
}

}  // namespace
}  // namespace dockyard
