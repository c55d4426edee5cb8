package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.browser.Browser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Layers, comparison and error by time on the page of a view, in a real browser. */
@Timeout(60)
class LookPageTest {
    @RegisterExtension
    static final Browser browser = new Browser();

    private static final String SCENE =
            """
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "name": "ball",
                             "material": { "type": "matte", "color": "#bc0000" } } ]
            }
            """;

    @TempDir
    private Path folder;

    private ServedView client;

    @BeforeEach
    void open() throws Exception {
        client = new ServedView(Files.writeString(folder.resolve("scene.json"), SCENE), 4);
        ViewedPage.open(browser, client.view.address());
        ViewedPage.untilFinished(browser);
    }

    @AfterEach
    void close() throws Exception {
        client.close();
    }

    private static void press(String selector, String key) throws Exception {
        browser.value("document.querySelector('" + selector + "').dispatchEvent(new KeyboardEvent('keydown', { key: '"
                + key + "', bubbles: true })); 0");
    }

    private static void click(String selector) throws Exception {
        browser.value("document.querySelector('" + selector + "').click(); 0");
    }

    /** Waits until a layer is shown at full resolution, with its explanation. */
    private static void untilShown(String layer) throws Exception {
        browser.until("document.querySelector('#picture').src.includes('layer=" + layer + "') && " + ViewedPage.IS_WHOLE
                + " && !['', 'It is being rendered.'].includes(document.querySelector('#meaning').textContent)");
    }

    @Test
    void keysChooseWhatIsShown() throws Exception {
        Set<String> all = new HashSet<>(Set.of(ViewedPage.pixels(browser)));
        String[] layers = {"albedo", "normal", "depth", "object", "material", "error", "samples"};
        for (int i = 0; i < layers.length; i++) {
            press("#stage", String.valueOf(i + 2));
            untilShown(layers[i]);
            assertEquals(
                    layers[i],
                    browser.value("document.querySelector('#layer').value").asString());
            all.add(ViewedPage.pixels(browser));
        }
        // One object of one material: these two are alike.
        assertEquals(layers.length, all.size());
        press("#stage", "g");
        untilShown("denoised");
        assertFalse(all.contains(ViewedPage.pixels(browser)));
        press("#stage", "1");
        browser.until("document.querySelector('#picture').src.includes('picture.png')");
        assertEquals(List.of(), browser.problems());
    }

    @Test
    void whatIsUnderThePointerIsNamed() throws Exception {
        press("#stage", "5");
        untilShown("object");
        assertTrue(browser.text("#legend").contains("ball, object 0 (sphere)"));
        int[] middle = middle();
        browser.call("Input.dispatchMouseEvent", mouse("mouseMoved", middle[0], middle[1], 0));
        browser.until("document.querySelector('#reading').textContent == 'object: ball, object 0 (sphere)'");
        // The legend is written anew when a finer layer comes.
        browser.until("document.querySelectorAll('#legend .here').length == 1");
        press("#stage", "4");
        untilShown("depth");
        assertEquals(
                2,
                browser.value("document.querySelectorAll('#marks li').length").asInt());
        assertTrue(browser.value("document.querySelector('#scale').offsetHeight > 0")
                .asBoolean());
    }

    private static int[] middle() throws Exception {
        String box =
                "(b => [b.left + b.width / 2, b.top + b.height / 2])(document.querySelector('#picture').getBoundingClientRect())";
        return new int[] {
            browser.value(box + "[0]").asInt(), browser.value(box + "[1]").asInt()
        };
    }

    private static String mouse(String type, int x, int y, int buttons) {
        return "{\"type\":\"" + type + "\",\"x\":" + x + ",\"y\":" + y + ",\"button\":\""
                + (buttons == 0 ? "none" : "left") + "\",\"buttons\":" + buttons + ",\"clickCount\":1}";
    }

    private static int divider() throws Exception {
        return browser.value("Number(document.querySelector('#divider').getAttribute('aria-valuenow'))")
                .asInt();
    }

    private static void keep() throws Exception {
        click("#keep");
        browser.until("!document.querySelector('#divider').hidden && document.querySelector('#kept').naturalWidth > 0");
    }

    @Test
    void theDividerFollowsKeysMouseAndFingers() throws Exception {
        String eye = browser.text("#progress");
        keep();
        assertEquals(50, divider());
        press("#divider", "ArrowLeft");
        assertEquals(48, divider());
        press("#stage", ">");
        press("#stage", ">");
        assertEquals(52, divider());
        int[] middle = middle();
        int width =
                browser.value("document.querySelector('#picture').clientWidth").asInt();
        int from = middle[0] + width / 50;
        browser.call("Input.dispatchMouseEvent", mouse("mousePressed", from, middle[1], 1));
        browser.call("Input.dispatchMouseEvent", mouse("mouseMoved", middle[0] + width / 4, middle[1], 1));
        browser.call("Input.dispatchMouseEvent", mouse("mouseReleased", middle[0] + width / 4, middle[1], 1));
        browser.until("Math.abs(document.querySelector('#divider').getAttribute('aria-valuenow') - 75) <= 1");
        touch("touchStart", middle[0] + width / 4, middle[1]);
        touch("touchMove", middle[0] - width / 4, middle[1]);
        browser.call("Input.dispatchTouchEvent", "{\"type\":\"touchEnd\",\"touchPoints\":[]}");
        browser.until("Math.abs(document.querySelector('#divider').getAttribute('aria-valuenow') - 25) <= 1");
        assertTrue(browser.value("document.querySelector('#kept').style.clipPath")
                .asString()
                .contains("75"));
        // Nothing of this turned the camera.
        assertTrue(browser.value("document.querySelector('#save').disabled").asBoolean());
        assertEquals(eye, browser.text("#progress"));
        press("#stage", "s");
        assertTrue(browser.value("document.querySelector('#divider').hidden").asBoolean());
        click("#forget");
        browser.until("document.querySelector('#comparing').hidden");
    }

    private static void touch(String type, int x, int y) throws Exception {
        browser.call(
                "Input.dispatchTouchEvent",
                "{\"type\":\"" + type + "\",\"touchPoints\":[{\"x\":" + x + ",\"y\":" + y + "}]}");
    }

    @Test
    void aChangeIsComparedWithThePictureThatWasKept() throws Exception {
        assertTrue(browser.value("document.querySelector('#layer option[value=difference]').disabled")
                .asBoolean());
        press("#stage", "a");
        browser.until("!document.querySelector('#divider').hidden");
        String before = ViewedPage.pixels(browser);
        client.act("action=exposure&x=-2");
        browser.until("document.querySelector('#stops').textContent == '-2 stops'");
        press("#stage", "9");
        untilShown("difference");
        browser.until("/RMSE 0\\.[0-9]+; the noise/.test(document.querySelector('#meaning').textContent)");
        assertTrue(!before.equals(ViewedPage.pixels(browser)));
        assertTrue(browser.value("document.querySelector('#divider').hidden").asBoolean());
    }

    @Test
    void theErrorIsDrawnByTime() throws Exception {
        click("#accuracy summary");
        // Passes of 1, 1 and 2 samples, or of 1 on a slow machine; the error is known from the second on.
        browser.until("document.querySelector('#curveText').textContent.includes('4 samples per pixel')");
        int points = browser.value("document.querySelectorAll('#curve .point').length")
                .asInt();
        assertTrue(points == 2 || points == 3, () -> points + " points");
        assertTrue(browser.value("document.querySelector('#curve').getBoundingClientRect().height > 80")
                .asBoolean());
        assertEquals(
                1,
                browser.value("document.querySelectorAll('#curve .expected').length")
                        .asInt());
        assertTrue(
                browser.text("#curveText").contains("4 samples per pixel, estimated. Dashed:"),
                browser.text("#curveText"));
        String x = "Number(document.querySelectorAll('#curve .point')[%d].getAttribute('cx'))";
        assertTrue(
                browser.value(String.format(x, 0) + "<" + String.format(x, 1)).asBoolean());
        assertEquals(List.of(), browser.problems());
    }

    @Test
    void theChosenPixelSaysHowExactItIs() throws Exception {
        press("#stage", "Enter");
        browser.until("/standard error± [0-9.e-]+, 0, 0samples4$/.test(document.querySelector('#facts').textContent)");
    }

    @Test
    void allOfItFitsOnAPhone() throws Exception {
        browser.call(
                "Emulation.setDeviceMetricsOverride",
                "{\"width\":320,\"height\":600,\"deviceScaleFactor\":1,\"mobile\":true}");
        try {
            browser.open(client.view.address().replace("/#", "/?phone#"));
            ViewedPage.untilFinished(browser);
            keep();
            press("#stage", "5");
            untilShown("object");
            click("#accuracy summary");
            browser.until("document.querySelectorAll('#curve .point').length > 0");
            assertEquals(
                    320, browser.value("document.scrollingElement.scrollWidth").asInt());
        } finally {
            browser.call("Emulation.clearDeviceMetricsOverride", "{}");
        }
    }
}
