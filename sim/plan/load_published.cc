#include "sim/plan/published.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"
#include "sim/plan/published_items.h"

namespace dockyard {
namespace {

/// Calls read(reader) for each mapping of a list.
template <class Read>
void ForItems(const YamlReader& in, const char* key, std::vector<std::string> keys, Read&& read) {
  if (!in.Has(key)) return;
  const YamlNode& list = in.List(key, 1, kMostPublishedItems);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    read(YamlReader(list.items[i], YamlReader::PathOf(in.PathOf(key), i), keys));
  }
}

void ReadCampaigns(const YamlReader& in, Published& published) {
  ForItems(in, "campaigns", {"name", "file"}, [&](const YamlReader& item) {
    const std::string name = item.Text("name");
    const bool plain =
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    const bool fresh = std::none_of(published.campaigns.begin(), published.campaigns.end(),
                                    [&](const auto& each) { return each.name == name; });
    // It names a folder beside `figures`.
    if (!plain || !fresh || name == "figures") {
      item.Refuse("name", "a name of its own in small letters, digits and _");
    }
    published.campaigns.push_back({name, item.File("file")});
  });
  if (published.campaigns.empty()) in.List("campaigns", 1, kMostPublishedItems);
}

std::size_t RowNamed(const PublishedName& name, const Published& published) {
  for (std::size_t i = 0; i < published.rows.size(); ++i) {
    if (published.rows[i].name != name.text) continue;
    if (published.rows[i].paper) return i;
    throw ConfigError(name.place.Text() + ": " + name.path +
                      ": expected a row with a published count, found '" + name.text + "'");
  }
  throw ConfigError(name.place.Text() + ": " + name.path + ": expected the name of a row, found '" +
                    name.text + "'");
}

void ReadRows(const YamlReader& in, Published& published) {
  in.List("rows", 1, kMostPublishedItems);
  ForItems(in, "rows", {"name", "paper", "says", "where", "campaign", "runs", "outcomes"},
           [&](const YamlReader& item) {
             PublishedRow row{item.Text("name"), CountOf(item, "paper"), FiltersOf(item)};
             if (item.Has("campaign")) {
               // The paper's runs are repeated by the first campaign alone.
               row.campaign = NameOf(item, "campaign");
               row.runs = item.Integer("runs", 1, kMostPublishedRuns);
             } else if (item.Has("runs")) {
               item.Refuse("runs", "none without a campaign: the first has the paper's");
             }
             row.outcomes = NamesOf(item, "outcomes");
             row.says = item.TextOr("says", "");
             published.rows.push_back(std::move(row));
           });
  published.total = RowNamed(NameOf(in, "total"), published);
  for (const PublishedName& name : NamesOf(in, "judged")) {
    const std::size_t row = RowNamed(name, published);
    const auto& judged = published.judged;
    if (row == published.total || std::find(judged.begin(), judged.end(), row) != judged.end()) {
      throw ConfigError(name.place.Text() + ": " + name.path +
                        ": expected each row once and no total, found '" + name.text + "'");
    }
    published.judged.push_back(row);
  }
}

void ReadFailures(const YamlReader& in, Published& published) {
  ForItems(in, "failures", {"name", "paper", "says", "where", "cases", "judged"},
           [&](const YamlReader& item) {
             FailureClass failure{item.Text("name"),
                                  CountOf(item, "paper"),
                                  item.TextOr("says", ""),
                                  FiltersOf(item),
                                  {}};
             item.List("cases", 1, kMostPublishedItems);
             ForItems(item, "cases", {"outcomes", "sighting", "methods", "where"},
                      [&](const YamlReader& each) {
                        FailureCase found{NamesOf(each, "outcomes"), false,
                                          TextsOf(each, "methods"), ColumnFiltersOf(each)};
                        if (each.Has("sighting"))
                          found.wrong_sighting = each.Choice("sighting", {"wrong"}) == 0;
                        failure.cases.push_back(std::move(found));
                      });
             failure.judged = item.BoolOr("judged", false);
             if (failure.judged && !failure.paper) {
               item.Refuse("judged", "the paper's count of a class that is judged");
             }
             published.failures.push_back(std::move(failure));
           });
  published.others = in.TextOr("others", "");
}

void ReadSightings(const YamlReader& root, Published& published) {
  if (!root.Has("sightings")) return;
  const YamlReader in(root.Child("sightings"), "sightings",
                      {"wrong_place_m", "wrong_heading_deg", "methods", "within_m", "errors"});
  published.wrong_place_m = in.Number("wrong_place_m", Positive(100.0));
  published.wrong_heading_rad = in.Degrees("wrong_heading_deg", Positive(180.0));
  published.methods = TextsOf(in, "methods");
  published.within_m = in.Number("within_m", Positive(100.0));
  ForItems(in, "errors", {"at_m", "r_m", "heading_deg"}, [&](const YamlReader& item) {
    published.errors.push_back({item.Number("at_m", Positive(1000.0)),
                                item.NumberOr("r_m", std::nan(""), NonNegative(1000.0)),
                                item.DegreesOr("heading_deg", std::nan(""), NonNegative(180.0))});
  });
}

void ReadMeasures(const YamlReader& in, Published& published) {
  ForItems(in, "measures", {"name", "campaign", "measure", "where", "low", "high", "of", "judged"},
           [&](const YamlReader& item) {
             PublishedMeasure measure{item.Text("name"), NameOf(item, "campaign"),
                                      NameOf(item, "measure"), FiltersOf(item)};
             measure.low = item.NumberOr("low", std::nan(""), Between(-1e9, 1e9));
             measure.high = item.NumberOr("high", std::nan(""), Between(-1e9, 1e9));
             measure.counted = item.ChoiceOr("of", 0, {"all", "counted"}) == 1;
             if (std::isnan(measure.low) != std::isnan(measure.high)) {
               item.Refuse(std::isnan(measure.low) ? "high" : "low", "low and high, or neither");
             }
             measure.judged = item.BoolOr("judged", false);
             if (measure.judged && std::isnan(measure.low)) {
               item.Refuse("judged", "low and high of a measure that is judged");
             }
             if (measure.high < measure.low) item.Refuse("high", "a number from low on");
             published.measures.push_back(std::move(measure));
           });
}

void ReadFigures(const YamlReader& in, Published& published) {
  ForItems(
      in, "figures", {"file", "title", "shows", "where", "at_least", "channels"},
      [&](const YamlReader& item) {
        PublishedFigure figure;
        figure.file = item.Text("file");
        if (figure.file.find('/') != std::string::npos || figure.file[0] == '.') {
          item.Refuse("file", "a file's name");
        }
        figure.title = item.Text("title");
        figure.kind = static_cast<PublishedFigure::Kind>(item.Choice("shows", {"starts", "run"}));
        figure.where = FiltersOf(item);
        figure.channels = NamesOf(item, "channels");
        if (item.Has("at_least")) {
          const YamlNode& least = item.Child("at_least");
          if (least.kind != YamlNode::Kind::kMapping || least.keys.size() != 1) {
            item.Refuse("at_least", "a measure with its least value");
          }
          const std::string& name = least.keys[0].name;
          const YamlReader value(least, item.PathOf("at_least"), {name});
          figure.least = value.Number(name, Between(-1e9, 1e9));
          figure.least_measure = {name, least.keys[0].place, value.PathOf(name)};
        }
        published.figures.push_back(std::move(figure));
      });
}

}  // namespace

Published LoadPublished(const std::string& file) {
  const YamlNode tree = LoadYaml(file);
  const YamlReader in(
      tree, "",
      {"reproduction", "source", "campaigns", "replications", "counted", "strict", "rows", "total",
       "judged", "failures", "others", "sightings", "measures", "figures", "choices"});
  Published published;
  published.name = in.Text("reproduction");
  if (published.name.find('/') != std::string::npos || published.name[0] == '.') {
    in.Refuse("reproduction", "a name that its results folder can have");
  }
  published.file = file;
  published.source = in.Text("source");
  ReadCampaigns(in, published);
  published.replications = in.IntegerOr("replications", 1, 1, 10000);
  in.List("counted", 1, kMostPublishedItems);
  published.counted = NamesOf(in, "counted");
  published.strict = NamesOf(in, "strict");
  ReadRows(in, published);
  ReadFailures(in, published);
  ReadSightings(in, published);
  ReadMeasures(in, published);
  ReadFigures(in, published);
  if (in.Has("choices")) published.choices_file = in.File("choices");
  return published;
}

}  // namespace dockyard
