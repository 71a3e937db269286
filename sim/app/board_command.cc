#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim/app/board_sheet.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/vision_files.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

struct BoardArguments {
  std::string board, out;
  std::optional<std::string> paper{};
  bool tile = false, json = false;
};

constexpr const char* kBoardHelp = R"(Draw a fiducial board for printing at true size.

Examples:
  dockyard board models/boards/grid_4x3.yaml --out out/grid.pdf --paper a3
  dockyard board {target} --out out/station.pdf --paper a4 --tile
  dockyard board models/boards/five_discs.yaml --out out/five.svg

FILE is a board's file or a station's. --out names the format by its ending: .svg or .pdf. Without
--paper the page is as large as the board needs. Print it at 100 % and hold a rule against the 100
mm below the board; matt paper, laid flat on a stiff plate.)";

int Board(const BoardArguments& arguments, const Invocation& call) {
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  if (ending != ".svg" && ending != ".pdf") {
    throw UsageError("--out: expected a file .svg or .pdf, found '" + arguments.out + "'");
  }
  if (arguments.tile && !arguments.paper) {
    throw UsageError("--tile: expected --paper with it, the size of the tiles");
  }
  const NamedBoard named = BoardOf(arguments.board, call.systems);
  const std::vector<Page> pages = BoardPages(named, arguments.paper, arguments.tile);
  if (ending == ".svg" && pages.size() > 1) {
    throw UsageError("--out: expected a file .pdf for " + std::to_string(pages.size()) +
                     " pages, found '" + arguments.out + "'");
  }
  WriteWhole(arguments.out, ending == ".svg" ? SvgText(pages[0]) : PdfText(pages));
  if (arguments.json) {
    const Json answer{{"file", arguments.out},
                      {"board", named.name},
                      {"pages", pages.size()},
                      {"page_mm", {pages[0].width_mm, pages[0].height_mm}},
                      {"warnings", call.warnings}};
    std::printf("%s\n", answer.dump(1).c_str());
    return kExitDone;
  }
  std::printf("%s: %s, %s of %.0f x %.0f mm\n", arguments.out.c_str(), named.name.c_str(),
              CountText(pages.size(), "page").c_str(), pages[0].width_mm, pages[0].height_mm);
  return kExitDone;
}

}  // namespace

void AddBoardCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<BoardArguments>();
  CLI::App* command = app.add_subcommand("board", kBoardHelp);
  command->add_option("FILE", arguments->board, "a board's file, or a station's")
      ->required()
      ->type_name("FILE");
  command->add_option("--out", arguments->out, "the drawing, .svg or .pdf")->required();
  command->add_option("--paper", arguments->paper, "a4, a3, a2, a1, a0 or letter, either way round")
      ->check(CLI::IsMember(PaperNames()));
  command->add_flag("--tile", arguments->tile,
                    "on several papers (.pdf) when it is too large for one");
  command->add_flag("--json", arguments->json, "print JSON");
  command->callback([arguments, &call] { call.exit_code = Board(*arguments, call); });
}

}  // namespace dockyard
