// SPDX-License-Identifier: Apache-2.0
#include "output/html_page.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "output/xml_text.hpp"

namespace pulvis {
namespace {

constexpr std::string_view style =
    "body{font:16px/1.5 'DejaVu Sans',sans-serif;color:#1a1a1a;background:#fff;max-width:72rem;margin:2rem "
    "auto;"
    "padding:0 1rem}h1,h2,h3{line-height:1.25}table{border-collapse:collapse;font-size:.85rem;margin:1rem 0}"
    "th,td{padding:.25rem .6rem;border-bottom:1px solid #ddd;text-align:left;vertical-align:top}"
    "th{border-bottom:2px solid #444}td.number{text-align:right;white-space:nowrap;font-variant-numeric:"
    "tabular-nums}tr.good td:last-child{color:#006b4f}tr.bad td{background:#fdeee6;font-weight:600}"
    "img{max-width:100%;height:auto;margin:.5rem 0}@media print{body{margin:0;max-width:none}}";

bool is_number(const std::string& cell) {
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  while (*end == ' ' || *end == '%') ++end;
  return !cell.empty() && end != cell.c_str() && *end == '\0';
}

/// As RFC 3986 wants bytes in an address that are not plain.
std::string percent_encoded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-_.~ =:/,;()").find(c) != std::string_view::npos;
    if (plain)
      result += c;
    else
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return result;
}

}  // namespace

HtmlPage::HtmlPage(std::string title) : title_(std::move(title)) {}

void HtmlPage::heading(std::string_view text, int level) {
  body_ += fmt::format("<h{0}>{1}</h{0}>\n", level, xml_escape(text));
}

void HtmlPage::paragraph(std::string_view text) { body_ += fmt::format("<p>{}</p>\n", xml_escape(text)); }

void HtmlPage::table(const std::vector<std::string>& header, const std::vector<Row>& rows) {
  body_ += "<table>\n<thead><tr>";
  for (const std::string& cell : header) body_ += fmt::format("<th>{}</th>", xml_escape(cell));
  body_ += "</tr></thead>\n<tbody>\n";
  for (const Row& row : rows) {
    body_ += row.kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", row.kind);
    for (const std::string& cell : row.cells)
      body_ += fmt::format("<td{}>{}</td>", is_number(cell) ? " class=\"number\"" : "", xml_escape(cell));
    body_ += "</tr>\n";
  }
  body_ += "</tbody>\n</table>\n";
}

void HtmlPage::image(std::string_view svg, std::string_view alternative) {
  body_ += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;charset=utf-8,{}\">\n",
                       xml_escape(alternative), percent_encoded(svg));
}

std::string HtmlPage::text() const {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      xml_escape(title_), style, body_);
}

}  // namespace pulvis
