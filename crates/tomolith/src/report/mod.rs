//! Run folder → report.json, report.html, figures.
