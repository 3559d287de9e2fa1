#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace tripus::viewer {

/// A manifold in a gallery.
struct GalleryEntry {
  std::size_t line = 0;  ///< of the list, which orders the gallery
  std::string name;      ///< from outside: any bytes
  std::string page;      ///< file name beside the index; empty where there is no page
  std::string picture;   ///< file name of its thumbnail
  std::size_t tetrahedron_count = 0;
  double volume = 0;
  std::string boundary;  ///< "genus 2"
  std::string problem;   ///< why there is no page
};

/// Sides of the thumbnails, in pixels.
inline constexpr int kThumbnailWidth = 240;
inline constexpr int kThumbnailHeight = 180;

/// The index page: a card for each manifold with its thumbnail, which the browser loads when it
/// comes into sight, a search by name and orders by list, volume and tetrahedra. What has no page
/// is listed below with the reason. The page needs no graphics and nothing from the network.
std::string gallery_html(const std::string& title, std::span<const GalleryEntry> entries);

}  // namespace tripus::viewer
