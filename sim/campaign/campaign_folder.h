// A campaign's results folder:
//   resolved.yaml, identity.txt   what was run, and with which program and model files
//   results.csv, timing.csv       a line per finished run; in run order once the campaign stops
//   results.sqlite, summary.txt
//   points.csv, points.md         of a campaign with a grid or arms: a line per point
//   plots/                        curves.svg, bars.svg and figures of the system
//   runs/NNN/                     frames.bin, history.csv, sightings.json, plans.json,
//                                 outcome.json, figures of the system, messages.txt (the run's
//                                 printed lines, if any)
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/base/files.h"
#include "sim/log/results.h"
#include "sim/plan/make_run.h"
#include "sim/run/system.h"

namespace dockyard {

/// The folder holds something else, or is in use. The message says what to do.
class FolderTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using DrawCampaign =
    std::function<std::vector<Figure>(const std::string& title, const Scenario& first,
                                      const RowColumns&, const std::vector<RunResult>&)>;

/// "runs/007" of a results folder.
std::filesystem::path RunFolder(const std::filesystem::path& dir, int run);

/// What a folder belongs to.
struct FolderIdentity {
  RowColumns columns;         // of its results, with the campaign's labels
  std::string resolved_yaml;  // the campaign
  std::string identity;       // of program and model files; empty is not compared
};

class CampaignFolder {
 public:
  /// Makes the folder, or opens one that was left in the middle of the same campaign. Only one
  /// program at a time has it. Throws FolderTaken, ResultsError, IoError.
  CampaignFolder(const std::filesystem::path& dir, const Campaign& campaign, const RunMaker& maker,
                 const FolderIdentity& identity);
  ~CampaignFolder();
  CampaignFolder(const CampaignFolder&) = delete;
  CampaignFolder& operator=(const CampaignFolder&) = delete;

  const std::filesystem::path& dir() const { return dir_; }
  const FinishedRuns& finished() const { return finished_; }
  /// For the workers: a forked child closes it, so that the lock ends with the parent.
  int lock_descriptor() const { return lock_; }

  /// Empties and makes the run's folder.
  std::filesystem::path StartRun(int run) const;
  /// On the disk when it returns. Throws IoError.
  void Keep(const FinishedRun& run);
  /// Rewrites the tables in run order, adds database, summary and the figures of `draw`, if it is
  /// there; returns the summary. Throws IoError.
  std::string Conclude(const Campaign& campaign, const RunMaker& maker,
                       const DrawCampaign& draw) const;

 private:
  void Claim(const FolderIdentity& identity);
  void Lock();
  void CheckRows(const RunMaker& maker) const;
  void ReadNotes();
  void WritePoints(const Campaign& campaign, const std::vector<RunResult>& rows) const;

  std::filesystem::path dir_;
  RowColumns columns_;
  int lock_ = -1;
  FinishedRuns finished_;
  std::unique_ptr<LineAppender> results_, timing_;
};

}  // namespace dockyard
