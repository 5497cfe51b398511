// SPDX-License-Identifier: Apache-2.0
#include "output/html_page.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    "img{max-width:100%;height:auto;margin:.5rem 0}p,li{max-width:52rem}nav{font-size:.95rem}"
    "nav ul{margin:.3rem 0 1rem;padding-left:1.2rem}a{color:#0a4d8c}"
    ".notice{border-left:.35rem solid #d55e00;background:#fdf3ec;padding:.5rem .9rem}"
    ".images{display:flex;flex-wrap:wrap;gap:1rem;align-items:flex-start}"
    "figure{margin:.5rem 0;flex:0 1 auto;min-width:0;max-width:100%}"
    ".images.many{display:grid;grid-template-columns:repeat(auto-fill,minmax(24rem,1fr))}"
    "figcaption{font-size:.85rem;color:#444;max-width:52rem}.wide{overflow-x:auto}"
    "@media "
    "print{body{margin:0;max-width:none;font-size:11pt}nav{display:none}figure,tr,.notice{break-inside:"
    "avoid}h2,h3{break-after:avoid}a{color:inherit;text-decoration:none}.wide{overflow:visible}}";

bool is_number(const std::string& cell) {
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  while (*end == ' ' || *end == '%') ++end;
  return !cell.empty() && end != cell.c_str() && *end == '\0';
}

/// Whether all that stands in a column are numbers, or a dash for none.
bool is_column_of_numbers(const std::vector<HtmlPage::Row>& rows, std::size_t k) {
  return std::all_of(rows.begin(), rows.end(), [&](const HtmlPage::Row& row) {
    return k >= row.cells.size() || row.cells[k].empty() || row.cells[k] == "-" || is_number(row.cells[k]);
  });
}

/// RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t k) {
    return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u;
  };
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const unsigned triple = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
    for (int shift = 18; shift >= 0; shift -= 6) result += letters[triple >> shift & 63];
    for (std::size_t missing = bytes.size() - k; missing < 3; ++missing)
      result[result.size() - 3 + missing] = '=';
  }
  return result;
}

/// The whole number that stands behind the first ATTRIBUTE=" of an SVG image; 0 if none does.
int pixels_of(std::string_view svg, std::string_view attribute) {
  const auto at = svg.substr(0, svg.find('>', svg.find("<svg"))).find(attribute);
  return at == std::string_view::npos ? 0
                                      : std::atoi(std::string(svg.substr(at + attribute.size(), 8)).c_str());
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

std::string element_of(const PageImage& image) {
  std::string text = fmt::format("<img alt=\"{}\" src=\"{}\"", xml_escape(image.alternative), image.source);
  if (image.width > 0 && image.height > 0)
    text += fmt::format(" width=\"{}\" height=\"{}\"", image.width, image.height);
  return text + ">";
}

}  // namespace

PageImage svg_image(std::string_view svg, std::string alternative, std::string caption) {
  return {"data:image/svg+xml;charset=utf-8," + percent_encoded(svg), pixels_of(svg, " width=\""),
          pixels_of(svg, " height=\""), std::move(alternative), std::move(caption)};
}

std::optional<PageImage> png_image(std::string_view bytes, std::string alternative, std::string caption) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8), end("IEND\xae\x42\x60\x82", 8);
  if (bytes.size() < 45 || !bytes.starts_with(signature) || !bytes.ends_with(end)) return {};
  const auto word = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t k = at; k < at + 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
    return static_cast<int>(value & 0x7fffffff);
  };
  return PageImage{"data:image/png;base64," + base64(bytes), word(16), word(20), std::move(alternative),
                   std::move(caption)};
}

HtmlPage::HtmlPage(std::string title) : title_(std::move(title)) {}

void HtmlPage::heading(std::string_view text, int level) {
  if (level != 2) {
    body_ += fmt::format("<h{0}>{1}</h{0}>\n", level, xml_escape(text));
    return;
  }
  const std::string anchor = fmt::format("section-{}", sections_.size() + 1);
  body_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", anchor, xml_escape(text));
  sections_.emplace_back(anchor, text);
}

void HtmlPage::contents() { contents_ = body_.size(); }

void HtmlPage::notice(std::string_view text) {
  body_ += fmt::format("<p class=\"notice\">{}</p>\n", xml_escape(text));
}

void HtmlPage::list(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += fmt::format("<li>{}</li>\n", xml_escape(item));
  body_ += "</ul>\n";
}

void HtmlPage::paragraph(std::string_view text) { body_ += fmt::format("<p>{}</p>\n", xml_escape(text)); }

void HtmlPage::table(const std::vector<std::string>& header, const std::vector<Row>& rows) {
  body_ += "<div class=\"wide\"><table>\n";
  if (std::any_of(header.begin(), header.end(), [](const std::string& cell) { return !cell.empty(); })) {
    body_ += "<thead><tr>";
    for (const std::string& cell : header) body_ += fmt::format("<th>{}</th>", xml_escape(cell));
    body_ += "</tr></thead>\n";
  }
  body_ += "<tbody>\n";
  for (const Row& row : rows) {
    body_ += row.kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", row.kind);
    for (std::size_t k = 0; k < row.cells.size(); ++k)
      body_ += fmt::format("<td{}>{}</td>", is_column_of_numbers(rows, k) ? " class=\"number\"" : "",
                           xml_escape(row.cells[k]));
    body_ += "</tr>\n";
  }
  body_ += "</tbody>\n</table></div>\n";
}

void HtmlPage::image(std::string_view svg, std::string_view alternative) {
  body_ += element_of(svg_image(svg, std::string(alternative))) + "\n";
}

void HtmlPage::images(const std::vector<PageImage>& images) {
  body_ += images.size() > 1 ? "<div class=\"images many\">\n" : "<div class=\"images\">\n";
  for (const PageImage& image : images) {
    body_ += "<figure>";
    if (!image.source.empty()) body_ += element_of(image);
    if (!image.caption.empty())
      body_ += fmt::format("<figcaption>{}</figcaption>", xml_escape(image.caption));
    body_ += "</figure>\n";
  }
  body_ += "</div>\n";
}

std::string HtmlPage::text() const {
  std::string links;
  if (contents_) {
    links = "<nav><strong>On this page</strong>\n<ul>\n";
    for (const auto& [anchor, heading] : sections_)
      links += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor, xml_escape(heading));
    links += "</ul></nav>\n";
  }
  const std::size_t at = contents_.value_or(0);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}{3}{4}</body>\n</html>\n",
      xml_escape(title_), style, body_.substr(0, at), links, body_.substr(at));
}

}  // namespace pulvis
