// Hostile input by kinds: what mutations start from, and how the program reads the outcome.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace dockyard {

struct FuzzKind {
  std::string name;
  std::function<std::vector<std::string>()> seeds;  // makes good files, as bytes
  std::vector<std::string> words;                   // of such files, for mutations to put in
  /// Reads the bytes as the program does. Whether it took them; false where the program ends with
  /// the exit code of bad input. Anything else that happens is a fault. Keeps a folder of its own.
  std::function<bool(const std::string& bytes)> read;
};

/// A kind and how to make it, as some take a second.
struct NamedKind {
  std::string name;
  std::function<FuzzKind()> make;
};

/// Meshes as the importer meets them.
struct MeshFuzzOptions {
  // In this process, where a crash can be looked at; else guarded, as the program does.
  bool unguarded = false;
  std::string crash_dir;  // files whose importer crashed go here; empty: nowhere
  int import_every = 1;   // only each so manieth file that passes the check is imported
};

std::vector<NamedKind> AllFuzzKinds(const MeshFuzzOptions& options);

// The groups of which that list is made.
std::vector<NamedKind> PlanKinds();   // scenarios, campaigns, tables
std::vector<NamedKind> ModelKinds();  // robots, stations, soils, cameras; URDF
std::vector<NamedKind> MeshKinds(const MeshFuzzOptions& options);
std::vector<NamedKind> RecordKinds();  // logs of runs, MCAP files, results, beliefs
std::vector<NamedKind>
ImageKinds();  // image files; files of heights; pixels for the search of a board

/// Calls `read`; false for the exceptions that the program turns into the exit code of bad input.
bool ReadOrRefused(const std::function<void()>& read);

}  // namespace dockyard
