// Text files that are compiled into the library, so that the program needs no data directory.
#pragma once

namespace tribunal {

/// data/classes163.tsv: the 163 classes of a segment and a triangle.
extern const char* const embedded_classes163;
extern const char* const embedded_ray_classes;

/// exact/chart/plot.py: draws the charts; it imports plot_marks.py and plot_sheet.py of the same folder.
extern const char* const embedded_plot_script;
extern const char* const embedded_plot_marks;
extern const char* const embedded_plot_sheet;

/// exact/sweep/plot.py: draws sweeps and failure maps.
extern const char* const embedded_sweep_script;

/// exact/report/page/report.html: the page of a report, with a place for its JSON.
extern const char* const embedded_report_page;

}  // namespace tribunal
