package enlightenment.status;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.browser.Browser;
import enlightenment.image.Image;
import enlightenment.listen.ServerLog;
import enlightenment.render.RenderProgress;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The page of a render in one process as a browser shows it, after its scripts ran. */
@Timeout(600)
class RenderPageTest {
    @RegisterExtension
    static final Browser browser = new Browser();

    private final WatchedRender render = new WatchedRender("<b>a scene</b>", image -> image, System::nanoTime);
    private final RenderProgress progress = render.listening(RenderProgress.NONE);
    private StatusServer server;
    private String origin;

    @BeforeEach
    void serve() throws Exception {
        // Its clock stands still: a browser that is kept from its work for seconds is no page that is gone.
        server = StatusServer.start(render, 0, Thread::new, new ServerLog(line -> {}, () -> 0), () -> 0);
        origin = "http://127.0.0.1:" + server.port() + "/";
    }

    @AfterEach
    void end() throws Exception {
        server.close();
    }

    /** A picture of one colour. */
    private static Image plain(int width, int height, float red, float green) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i += 3) {
            rgb[i] = red;
            rgb[i + 1] = green;
        }
        return new Image(width, height, rgb);
    }

    /** The colour of a pixel of the picture that is shown, once it is this one. */
    private static void untilShown(String rgba) throws Exception {
        browser.value("function colour() { const c = document.createElement('canvas'); c.width = c.height = 1;"
                + "const g = c.getContext('2d'); g.drawImage(document.querySelector('#picture'), 0, 0);"
                + "return g.getImageData(0, 0, 1, 1).data.join(); } 0");
        browser.until("colour() == '" + rgba + "'");
    }

    @Test
    void aRenderIsShownFromItsBeginningToItsEndAndStaysWhenItIsGone() throws Exception {
        browser.open(origin);
        browser.until("document.readyState == 'complete' && document.querySelector('#numbers').textContent != ''");
        assertTrue(browser.text("#numbers").startsWith("The picture is being prepared; "), browser.text("#numbers"));
        assertTrue(browser.value("document.querySelector('#picture').hidden").asBoolean());

        progress.note("something about the budget");
        progress.planned(16, "samples");
        render.statistic("method", "raytrace");
        progress.progress(25, 100, () -> plain(10, 10, 1, 0));
        browser.until("document.querySelector('#state').textContent == '25 %'");
        untilShown("255,0,0,255");
        assertEquals("<b>a scene</b>", browser.text("#title"));
        assertEquals(
                "25 % \u2013 <b>a scene</b>", browser.value("document.title").asString());
        assertTrue(browser.text("#numbers").startsWith("25 of 100 pixels done; "), browser.text("#numbers"));
        assertTrue(browser.text("#facts").contains("methodraytrace"), browser.text("#facts"));
        assertTrue(browser.text("#facts").contains("16, decided by samples"), browser.text("#facts"));
        assertTrue(browser.text("#log").contains("something about the budget"), browser.text("#log"));
        assertTrue(browser.value("document.querySelector('#farm').hidden").asBoolean());
        assertEquals(
                "pixels",
                browser.value("document.querySelector('#picture').className").asString());
        assertEquals(
                0,
                browser.value("document.querySelector('#picture').width % 10").asInt());
        assertTrue(browser.value("document.querySelector('#picture').width").asInt() > 300);

        // The last picture is asked for a little later than usual: the request comes in when the render has ended.
        browser.value("const source = Object.getOwnPropertyDescriptor(HTMLImageElement.prototype, 'src');"
                + "Object.defineProperty(document.querySelector('#picture'), 'src', { get() { return source.get.call(this); },"
                + "set(url) { setTimeout(() => source.set.call(this, url), 300); } }); 0");
        progress.progress(100, 100, () -> plain(10, 10, 0, 1));
        browser.until("document.querySelector('#state').textContent == '100 %'");
        assertEquals(List.of(), browser.problems());
        assertTrue(
                browser.requests().stream().allMatch(r -> r.startsWith(origin)),
                browser.requests().toString());

        render.ended(true);
        server.awaitWatchers(300_000);
        server.close();
        untilShown("0,255,0,255");
        // What the browser has been sent it may not have shown yet.
        browser.until("document.querySelector('#state').textContent == 'finished'");
        int polls = browser.requests().size();
        browser.until("last.state == 'finished'");
        while (browser.requests().size() < polls + 2) {
            Thread.sleep(20);
        }
        assertEquals("", browser.text("#problem"));
        assertEquals("finished", browser.text("#state"));
        untilShown("0,255,0,255");
    }

    @Test
    void aRenderThatIsKilledIsToldOf() throws Exception {
        progress.progress(25, 100, () -> plain(10, 10, 1, 0));
        browser.open(origin);
        browser.until("document.readyState == 'complete' && document.querySelector('#state').textContent == '25 %'");
        server.close();
        browser.until("document.querySelector('#problem').textContent.startsWith('There is no answer')");
    }

    @Test
    void thePageRunsNothingThatIsNotItsOwn() throws Exception {
        browser.open(origin);
        browser.until("document.readyState == 'complete' && document.querySelector('#numbers').textContent != ''");
        browser.value(
                "document.addEventListener('securitypolicyviolation', e => window.violated = e.violatedDirective);"
                        + "const s = document.createElement('script'); s.textContent = 'window.ran = 1';"
                        + "document.body.append(s); 0");
        browser.until("window.violated !== undefined");
        assertTrue(browser.value("window.ran === undefined").asBoolean());
    }

    @Test
    void largePicturesFitOnNarrowScreens() throws Exception {
        progress.progress(25, 100, () -> plain(2000, 30, 1, 0));
        browser.call(
                "Emulation.setDeviceMetricsOverride",
                "{\"width\":320,\"height\":600,\"deviceScaleFactor\":1,\"mobile\":false}");
        try {
            browser.open(origin);
            browser.until("document.readyState == 'complete' && document.querySelector('#picture').naturalWidth > 0");
            browser.until("!document.querySelector('#picture').hidden");
            assertEquals(
                    320, browser.value("document.scrollingElement.scrollWidth").asInt());
        } finally {
            browser.call("Emulation.clearDeviceMetricsOverride", "{}");
        }
    }
}
