// Drawing on pictures for people: marks, words, pictures in pictures.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/io/belief.h"

namespace dockyard {

/// A place on a picture, from its top left [px].
struct Corner {
  int x = 0, y = 0;
};

/// That camera's marks as numbered rings: measured ones green, predicted ones orange with a cross.
/// @param scale  pixels of the picture per pixel of the camera
void DrawMarks(RgbImage& picture, const SightingReport& report, int camera, double scale = 1.0);

/// Words in white on a dark ground; `at` is its top left. What is no ASCII becomes '?'.
/// @param height_px  of a line
void DrawWords(RgbImage& picture, Corner at, const std::vector<std::string>& lines,
               double height_px);

/// In that width, and in proportion.
RgbImage Resized(const RgbImage& picture, int width);

/// Puts a picture with a light edge onto another; parts outside are left out.
void PutInset(RgbImage& picture, Corner at, const RgbImage& inset);

/// Both beside each other.
RgbImage SideBySide(const RgbImage& left, const RgbImage& right);

}  // namespace dockyard
