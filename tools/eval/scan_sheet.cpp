#include "tools/eval/scan_sheet.hpp"

#include <algorithm>
#include <string_view>

#include "tools/eval/fixed.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kPanelsByDefault = 24;
constexpr std::size_t kColumns = 6;
constexpr double kHead = 56.0;  // [px] of the title and the legend

constexpr const char* kLegend =
    "beams: grey in a wall, red in none, pale on the robot; walls blue, with their number; "
    "corners: disc where two walls meet, ring at a jump in range, square at a turn without a "
    "wall; orange convex, black concave";

/// What stands for it in XML.
std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else
      xml += c;
  }
  return xml;
}

std::string sigma_of(const SheetTitle& title) {
  const std::string smallest = fixed(1e3 * title.smallest_sigma, 1);
  const std::string largest = fixed(1e3 * title.largest_sigma, 1);
  return "sigma " + smallest + (smallest == largest ? "" : " to " + largest) + " mm";
}

}  // namespace

std::vector<std::size_t> scans_of_sheet(std::size_t scans, std::optional<std::size_t> every) {
  std::vector<std::size_t> chosen;
  if (every) {
    for (std::size_t i = 0; i < scans; i += *every) chosen.push_back(i);
    return chosen;
  }
  const std::size_t panels = std::min(scans, kPanelsByDefault);
  for (std::size_t i = 0; i < panels; ++i)
    chosen.push_back(panels > 1 ? i * (scans - 1) / (panels - 1) : 0);
  return chosen;
}

void ScanSheet::add(const ScanFindings& scan) {
  const double left = kPanelSize * static_cast<double>(count_ % kColumns);
  const std::size_t row = count_ / kColumns;
  const double top = kHead + kPanelSize * static_cast<double>(row);
  panels_ += scan_panel(scan, footprint_, left, top);
  ++count_;
}

std::string ScanSheet::document(const SheetTitle& title) const {
  const std::size_t rows = (count_ + kColumns - 1) / kColumns;
  const std::string width = fixed(kPanelSize * static_cast<double>(kColumns), 0);
  const std::string height = fixed(kHead + kPanelSize * static_cast<double>(rows), 0);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\">\n<style>" + kPanelStyle +
         "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
         "<text style=\"font-size:20px\" x=\"10\" y=\"24\">" +
         escaped(title.file + ", " + title.method + ", " + sigma_of(title)) +
         "</text>\n<text x=\"10\" y=\"45\">" + kLegend + "</text>\n" + panels_ + "</svg>\n";
}

}  // namespace perceptor
