package enlightenment.view;

import enlightenment.browser.Browser;

/** When the page of a view shows what it is going to show. */
final class ViewedPage {
    /** The size in pixels that the view has, as the page says it. */
    private static final String SIZE =
            "(document.querySelector('#progress').textContent.match(/^\\d+ × \\d+/) || ['0 × 0'])[0]"
                    + ".split(' × ').map(Number)";

    private static final String PICTURE = "document.querySelector('#picture')";

    /** Whether the picture's element shows an image of the view's size, decoded. */
    static final String IS_WHOLE = "(w => !" + PICTURE + ".hidden && " + PICTURE + ".complete && " + PICTURE
            + ".naturalWidth == w)(" + SIZE + "[0])";

    private ViewedPage() {}

    /** Opens a view in a window that is small, so that there are few pixels to render, and not yet a phone's. */
    static void open(Browser browser, String address) throws Exception {
        browser.call(
                "Emulation.setDeviceMetricsOverride",
                "{\"width\":760,\"height\":200,\"deviceScaleFactor\":1,\"mobile\":false}");
        browser.open(address);
    }

    /**
     * Waits until the last pass is shown. Views begin with a size of their own: that picture is finished, too, if the page is late to say how
     * large its window is.
     */
    static void untilFinished(Browser browser) throws Exception {
        browser.until("document.readyState == 'complete' && " + IS_WHOLE
                + " && document.querySelector('#progress').textContent.endsWith('finished')"
                + " && ((s, [w, h]) => Math.abs(s.clientWidth - w) <= 1 || Math.abs(s.clientHeight - h) <= 1)"
                + "(document.querySelector('#stage'), " + SIZE + ")");
    }

    /** The colours that the picture's element shows, 24 × 16 of them. */
    static String pixels(Browser browser) throws Exception {
        // While an image is being put in place nothing would be drawn.
        String drawn = "(() => { const i = " + PICTURE + "; if (!i.complete || !i.naturalWidth) return '';"
                + " const c = document.createElement('canvas');"
                + " c.width = 24; c.height = 16; const g = c.getContext('2d'); g.drawImage(i, 0, 0, 24, 16);"
                + " return g.getImageData(0, 0, 24, 16).data.join(); })()";
        browser.until("(window.drawn = " + drawn + ") != ''");
        return browser.value("window.drawn").asString();
    }
}
