#include <gmock/gmock.h>

#include <algorithm>

#include "models/axel/load_station.h"
#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

StationModel Station() { return LoadStation(SourceFile("models/axel/station/station.yaml")); }

std::string ChangedMessage(const std::string& from, const std::string& to) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string name = "models/axel/station/station.yaml";
  const std::string file = folder.Write(name, Replaced(Slurp(SourceFile(name)), from, to));
  return MessageOf([&] { LoadStation(file); }, folder);
}

TEST(Station, IsTippedForwardBy5Degrees) {
  const Pose3 X_SM = MouthInStation(Station());
  EXPECT_NEAR(Degrees(std::asin(-X_SM.R(2, 0))), 5.0, 1e-9);
  EXPECT_NEAR(X_SM.p.z(), 0.34, 1e-12);
}

TEST(Station, HasTheInertiaOfASolidBox) {
  const StationModel station = Station();
  const double m = 35, a = 0.795, b = 0.95, c = 0.69;
  const Eigen::Vector3d moments(m * (b * b + c * c) / 12, m * (a * a + c * c) / 12,
                                m * (a * a + b * b) / 12);
  EXPECT_NEAR(station.module.mass_kg, m, 1e-12);
  EXPECT_LT((station.module.I_LCom_L.diagonal() - moments).norm(), 1e-8);
  EXPECT_LT((station.module.p_LoCom_L - Eigen::Vector3d(-0.4025, 0, 0.425)).norm(), 1e-9);
}

TEST(Station, YieldsAllOverAsItsConeDoesUnlessItsFileSaysMore) {
  const StationModel station = Station();
  EXPECT_EQ(station.body_contact.stiffness_n_per_m, station.cone.contact_stiffness_n_per_m);
  EXPECT_EQ(station.body_contact.damping_ns_per_m, station.cone.contact_damping_ns_per_m);
  EXPECT_EQ(station.body_contact.friction, 0.4);
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string name = "models/axel/station/station.yaml";
  const auto Load = [&](const std::string& to) {
    const std::string from = "body_contact:\n  friction: 0.4 # assumed\n";
    return LoadStation(folder.Write(name, Replaced(Slurp(SourceFile(name)), from, to)));
  };
  const StationModel stiff = Load("body_contact:\n  stiffness_n_per_m: 3e6\n  friction: 0.5\n");
  EXPECT_EQ(stiff.body_contact.stiffness_n_per_m, 3e6);
  EXPECT_EQ(stiff.body_contact.damping_ns_per_m, station.cone.contact_damping_ns_per_m);
  EXPECT_EQ(stiff.body_contact.friction, 0.5);
}

TEST(Station, SlidesBeforeItTipsWhenPulledAtTheMouth) {
  const StationModel station = Station();
  const double weight_n = station.module.mass_kg * 9.81;
  double front = -1e9;
  for (const FootModel& foot : station.feet) front = std::max(front, foot.p_SF.x());
  const double tips_n = weight_n * (front - station.module.p_LoCom_L.x()) / station.mouth_height_m;
  EXPECT_LT(station.foot_friction * weight_n, 0.7 * tips_n);
}

TEST(Station, LeavesTheArmsWayIntoTheConeOpen) {
  const StationModel station = Station();
  for (double depth = 0.0; depth <= 0.35; depth += 0.01) {
    for (int i = 0; i < 24; ++i) {
      const double radius = station.cone.mouth_radius_m * 0.999, angle = 2 * kPi * i / 24;
      const Eigen::Vector3d p(-depth, radius * std::cos(angle),
                              station.mouth_height_m + radius * std::sin(angle));
      for (const Collision& part : station.module.collisions) {
        const auto& box = std::get<BoxShape>(part.shape);
        const Eigen::Vector3d q = (Inverse(part.X_LG) * p).cwiseAbs();
        EXPECT_TRUE((q.array() > 0.5 * box.size_m.array() - 1e-9).any()) << part.name;
      }
    }
  }
}

TEST(Station, HasNoGapBetweenFaceAndBoxes) {
  // The boxes leave a square hole; its corners must be covered by the annular face.
  const StationModel station = Station();
  double hole = 1.0;
  for (const Collision& part : station.module.collisions) {
    if (part.name != "left") continue;
    hole = part.X_LG.p.y() - 0.5 * std::get<BoxShape>(part.shape).size_m.y();
  }
  EXPECT_LE(hole * std::sqrt(2.0), station.cone.face_outer_radius_m + 1e-9);
}

TEST(Station, NothingButTheFaceReachesInFrontOfTheBoard) {
  const StationModel station = Station();
  for (const Visual& visual : station.module.visuals) {
    if (visual.name == "cone_face") continue;
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      EXPECT_LT((visual.X_LV * v).x(), -0.003) << visual.name;
    }
  }
}

TEST(Station, StaysAboveTheGroundWhenTipped) {
  const StationModel station = Station();
  const Pose3 X_SM = MouthInStation(station);
  const Eigen::Vector3d p_SM(0, 0, station.mouth_height_m);
  for (const Visual& visual : station.module.visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      EXPECT_GT((X_SM * (visual.X_LV * v - p_SM)).z(), 0.05) << visual.name;
    }
  }
  for (const Visual& visual : station.stand_visuals) {
    for (const Eigen::Vector3d& v : visual.mesh->vertices) EXPECT_GE((visual.X_LV * v).z(), -1e-9);
  }
}

TEST(Station, BoardIsLaidOutWithoutSymmetry) {
  // No half-turn and no mirror image maps the discs onto discs.
  const FiducialBoard board = Station().board;
  const auto maps_onto_itself = [&](double sx, double sy) {
    for (const Fiducial& a : board.fiducials) {
      bool found = false;
      for (const Fiducial& b : board.fiducials) {
        found = found || (b.p_BF - Eigen::Vector2d(sx * a.p_BF.x(), sy * a.p_BF.y())).norm() < 0.05;
      }
      if (!found) return false;
    }
    return true;
  };
  EXPECT_FALSE(maps_onto_itself(-1, 1));
  EXPECT_FALSE(maps_onto_itself(1, -1));
  EXPECT_FALSE(maps_onto_itself(-1, -1));
}

TEST(StationFile, RefusesADiscOverTheMouth) {
  const std::string disc = "{x_m: 0.27, y_m: 0.04,";
  const std::string text = Slurp(SourceFile("models/axel/station/station.yaml"));
  const auto line = 1 + std::count(text.begin(), text.begin() + text.find(disc), '\n');
  EXPECT_EQ(ChangedMessage(disc, "{x_m: 0.10, y_m: 0.04,"),
            "models/axel/station/station.yaml:" + std::to_string(line) +
                ":7: board.fiducials[6]: expected a disc clear of the cone's mouth and face, it "
                "overlaps by 0.056 m");
}

TEST(StationFile, RefusesDiscsThatTouchOrStickOut) {
  EXPECT_THAT(ChangedMessage("{x_m: -0.12, y_m: -0.18,", "{x_m: -0.30, y_m: -0.18,"),
              HasSubstr("board.fiducials[1]: expected a disc clear of the others, it overlaps "
                        "number 0"));
  EXPECT_THAT(ChangedMessage("{x_m: -0.36,", "{x_m: -0.41,"),
              HasSubstr("board.fiducials[0]: expected a disc inside the board, it sticks out"));
}

TEST(StationFile, WantsRotationsThatAreTold) {
  EXPECT_THAT(
      ChangedMessage("y_m: 0.17, rotation_deg: 45", "y_m: 0.17, rotation_deg: 30"),
      HasSubstr("board.fiducials[7].rotation_deg: expected one of -45, 0, 45, 90, found '30'"));
}

TEST(StationFile, RefusesAConeThatDoesNotNarrow) {
  EXPECT_THAT(ChangedMessage("throat_radius_m: 0.0320", "throat_radius_m: 0.13"),
              HasSubstr("cone.throat_radius_m: expected less than mouth_radius_m, found '0.13'"));
  EXPECT_THAT(ChangedMessage("face_outer_radius_m: 0.17", "face_outer_radius_m: 0.11"),
              HasSubstr("cone.face_outer_radius_m: expected more than mouth_radius_m"));
}

TEST(StationFile, RefusesFeetThatDoNotCarryIt) {
  const std::string message =
      ChangedMessage("    - {x: -0.65, y: 0.25}\n    - {x: -0.65, y: -0.25}\n",
                     "    - {x: -0.3, y: 0.25}\n    - {x: -0.3, y: -0.25}\n");
  EXPECT_THAT(message, HasSubstr("feet: expected soles on both sides of the centre of mass"));
}

TEST(SoilFiles, HoldTheirSourcesNumbers) {
  const SoilModel loose = LoadSoil(SourceFile("models/soils/loose_sand.yaml"));
  const SoilModel compact = LoadSoil(SourceFile("models/soils/compact_gravel.yaml"));
  EXPECT_EQ(loose.n, 1.46);
  EXPECT_EQ(loose.k_phi, 6.1e6);
  EXPECT_EQ(loose.widest_plate_m, 0.100);
  EXPECT_EQ(compact.widest_plate_m, 0.0);
  EXPECT_DOUBLE_EQ(loose.friction_angle_rad, Radians(29));
  EXPECT_EQ(compact.n, 0.6);
  EXPECT_EQ(compact.k_phi, 2.5e6);
  EXPECT_EQ(compact.cohesion_pa, 5000);
}

TEST(SoilFiles, EachIsNamedWithItsSource) {
  for (const char* name : {"compact_gravel", "fjs_1", "grc_1", "lete_sand", "loose_sand",
                           "pavlov_90", "wong_dry_sand"}) {
    const SoilModel soil = LoadSoil(SourceFile(std::string("models/soils/") + name + ".yaml"));
    EXPECT_FALSE(soil.source.empty()) << name;
    EXPECT_GT(soil.k_c / 0.15 + soil.k_phi, 0.0) << name;
  }
}

TEST(SoilFiles, NegativeModulusUnderANarrowWheelIsRefused) {
  const std::string file = SourceFile("models/soils/grc_1.yaml");
  const SoilModel soil = LoadSoil(file);
  WheelModel wheel;
  wheel.width_m = 0.15;
  EXPECT_NO_THROW(CheckCarries(soil, file, wheel.width_m));
  wheel.width_m = 0.05;
  EXPECT_THROW(CheckCarries(soil, file, wheel.width_m), ConfigError);
}

TEST(WheelFiles, AreReadStrictly) {
  const ScratchFolder folder;
  const std::string text = Slurp(SourceFile("models/wheels/pavlov_grouser.yaml"));
  const auto message = [&](const char* from, const char* to) {
    const std::string file = folder.Write("wheel.yaml", Replaced(text, from, to));
    return MessageOf([&] { LoadWheel(file); }, folder);
  };
  EXPECT_THAT(message("width_m: 0.060", "width: 0.060"), HasSubstr("wheel.yaml:"));
  EXPECT_THAT(message("radius_m: 0.0575", "radius_m: 58"),
              HasSubstr("radius_m: expected a number > 0 and <= 2, found '58'"));
  EXPECT_THAT(message("height_m: 0.005", "height_m: 0"),
              HasSubstr("paddles.count: expected 0, or a height_m and a thickness_m above 0"));
}

TEST(SoilFiles, UnitsMistakenAreOutOfRange) {
  const ScratchFolder folder;
  const std::string text = Slurp(SourceFile("models/soils/loose_sand.yaml"));
  const auto message = [&](const char* from, const char* to) {
    const std::string file = folder.Write("soil.yaml", Replaced(text, from, to));
    return MessageOf([&] { LoadSoil(file); }, folder);
  };
  EXPECT_THAT(message("shear_modulus_m: 0.0075", "shear_modulus_m: 21"),
              HasSubstr("shear_modulus_m: expected a number from 1e-04 to 0.5, found '21'"));
  EXPECT_THAT(message("friction_angle_deg: 29", "friction_angle_deg: 0.506"),
              HasSubstr("friction_angle_deg: expected a number from 1 to 60, found '0.506'"));
  EXPECT_THAT(message("widest_m: 0.100", "widest_m: 0.05"),
              HasSubstr("plates.widest_m: expected a number from 0.06 to 5, found '0.05'"));
  EXPECT_THAT(message("plates: {narrowest_m: 0.060, widest_m", "plates: {widest_m"),
              HasSubstr("plates: missing key 'narrowest_m'"));
  EXPECT_THAT(message("density_kg_m3: 1330", "density_kg_m3: 1.33"),
              HasSubstr("density_kg_m3: expected a number from 200 to 5000, found '1.33'"));
}

}  // namespace
}  // namespace dockyard::axel
