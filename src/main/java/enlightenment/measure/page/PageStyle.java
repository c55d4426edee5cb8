package enlightenment.measure.page;

/** The style sheet of the page. */
final class PageStyle {
    static final String CSS =
            """
            :root { color-scheme: light; }
            body { margin: 0; background: #fff; color: #222; font: 17px/1.5 system-ui, sans-serif; }
            main { max-width: 62rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
            h1 { line-height: 1.2; margin-bottom: 0; }
            h2 { margin: 2.5rem 0 .5rem; border-bottom: 1px solid #ddd; }
            .quiet, figcaption { color: #555; }
            .warning { background: #fff4ce; padding: .5rem 1rem; border-left: 4px solid #b07d00; }
            .verdict { background: #eef5fb; border-left: 6px solid #0072b2; padding: .5rem 1.2rem; margin: 1.5rem 0; }
            .big { font-size: 1.35rem; font-weight: 600; margin: .5rem 0; }
            pre { background: #222; color: #fff; padding: .7rem 1rem; font-size: .95rem; white-space: pre-wrap; }
            figure { margin: 1rem 0; }
            img { max-width: 100%; height: auto; display: block; }
            .side { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 1rem; }
            .wide { overflow-x: auto; }
            table { border-collapse: collapse; font-size: .95rem; font-variant-numeric: tabular-nums; }
            th, td { text-align: left; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid #ddd; vertical-align: top; }
            th { color: #555; font-weight: 600; }
            """;

    private PageStyle() {}
}
