#include "plot/plot_svg.hpp"

#include <iterator>

#include "chart/svg.hpp"
#include "plot/draw_chart.hpp"

namespace myo::ui::plot {
namespace {

// Size of one plot [SVG pixels], chosen for a column of a page, and of its letters.
constexpr double width = 800.0, height = 202.0, letters = 12.0;

}  // namespace

std::string plots_svg(const std::vector<chart::Chart>& charts, const platform::Theme& theme) {
    chart::Palette palette = chart_palette(theme);
    palette.paper = palette.plot;
    // The viewer's font is unknown, so widths are estimated.
    const chart::LayoutStyle style = chart::compact_style(letters, 1.0);
    chart::Drawing drawing{{0.0, 0.0, width, 0.0}, "curves", {}};
    for (chart::Chart chart : charts) {
        chart.width_px = width;
        // In the window the lower of two plots has the labels for both; in a drawing each has its own.
        chart.x_labels = true;
        for (chart::Panel& panel : chart.panels) panel.height_px = height;
        const chart::Layout layout = chart::lay_out(chart, style, palette, chart::estimated_text_width,
                                                    {0.0, drawing.frame.height});
        chart::Drawing one = chart::draw(chart, layout, palette);
        // One drawing: each chart was laid out below the ones before.
        std::move(one.marks.begin(), one.marks.end(), std::back_inserter(drawing.marks));
        drawing.frame.height += layout.frame.height;
    }
    return chart::svg(drawing, true);
}

}  // namespace myo::ui::plot
