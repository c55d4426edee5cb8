package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.browser.Browser;
import enlightenment.listen.ServerLog;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Final renders and frames on the page of a view, in a real browser. */
@Timeout(60)
class RenderPageTest {
    @RegisterExtension
    static final Browser browser = new Browser();

    private static final String SCENE =
            """
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1,
                             "material": { "type": "matte", "color": "#ffffff" } } ],
              "animation": { "frames": 5, "framesPerSecond": 10,
                             "tracks": [ { "target": "/objects/0/center/0", "keys": { "0": 0, "4": 2 } } ] }
            }
            """;

    @TempDir
    private Path folder;

    private LiveView view;

    @BeforeEach
    void open() throws Exception {
        Path file = Files.writeString(folder.resolve("ball.json"), SCENE);
        LiveView.Options options = new LiveView.Options("ball.json", 0, 2, 2);
        view = LiveView.start(
                new FileSource(file), FileSource.FILES, options, new ServerLog(line -> {}, System::nanoTime));
        ViewedPage.open(browser, view.address());
        browser.until("document.readyState == 'complete' && !document.querySelector('#film').hidden"
                + " && document.querySelector('#width').value == '24' && !document.querySelector('#picture').hidden");
    }

    @AfterEach
    void close() throws Exception {
        view.close();
    }

    private static void run(String script) throws Exception {
        browser.value(script + "; 0");
    }

    private static void press(String key) throws Exception {
        run("document.querySelector('#stage').dispatchEvent(new KeyboardEvent('keydown', { key: '" + key
                + "', bubbles: true }))");
    }

    private static void untilFrame(int frame) throws Exception {
        browser.until("document.querySelector('#frame').textContent == '" + frame + " of 4'");
    }

    @Test
    void theButtonRendersWhatIsAskedForAndLinksToItsFiles() throws Exception {
        assertTrue(browser.value("document.querySelector('#files').hidden").asBoolean());
        run("document.querySelector('#width').value = 48;"
                + "document.querySelector('#width').dispatchEvent(new Event('input'))");
        assertEquals(
                "32", browser.value("document.querySelector('#height').value").asString());
        run("document.querySelector('#start').click()");
        browser.until("!document.querySelector('#files').hidden");
        assertTrue(browser.text("#course").startsWith("48 × 32, done in "), browser.text("#course"));
        assertEquals(
                "ball.png",
                browser.value("document.querySelector('#png').download").asString());
        // The first four bytes of OpenEXR files: 20000630 (its file layout document).
        run("fetch(document.querySelector('#exr').href).then(r => r.arrayBuffer())"
                + ".then(a => { window.magic = new DataView(a).getUint32(0, true) })");
        browser.until("window.magic == 20000630");
        assertEquals(List.of(), browser.problems());
    }

    @Test
    void aRenderIsCancelled() throws Exception {
        run("document.querySelector('#quality').value = 'samples';"
                + "document.querySelector('#quality').dispatchEvent(new Event('change'));"
                + "document.querySelector('#amount').value = 1000000;"
                + "document.querySelector('#width').value = 2000;"
                + "document.querySelector('#start').click()");
        browser.until("!document.querySelector('#cancel').hidden && document.querySelector('#start').disabled");
        run("document.querySelector('#cancel').click()");
        browser.until("document.querySelector('#course').textContent == 'Cancelled.'"
                + " && !document.querySelector('#start').disabled");
    }

    @Test
    void whatIsWrongWithAnOrderIsSaid() throws Exception {
        run("document.querySelector('#width').value = 60000; document.querySelector('#height').value = 60000;"
                + "document.querySelector('#start').click()");
        browser.until("document.querySelector('#notes').textContent"
                + ".startsWith('a picture of 60000x60000 pixels is larger')");
    }

    @Test
    void sliderAndKeysShowFrames() throws Exception {
        run("document.querySelector('#frames').value = 3;"
                + "document.querySelector('#frames').dispatchEvent(new Event('input'))");
        untilFrame(3);
        press(".");
        untilFrame(4);
        press(".");
        untilFrame(0);
        press(",");
        untilFrame(4);
        assertFalse(browser.value("document.querySelector('#problem').textContent != ''")
                .asBoolean());
    }

    @Test
    void playingShowsOneFrameAfterAnotherUntilItIsPaused() throws Exception {
        run("window.shown = new Set();"
                + "new MutationObserver(() => window.shown.add(document.querySelector('#frame').textContent))"
                + ".observe(document.querySelector('#frame'), { childList: true })");
        press(" ");
        browser.until("window.shown.size >= 3 && document.querySelector('#play').textContent == 'Pause'");
        press(" ");
        browser.until("document.querySelector('#play').textContent == 'Play'");
    }
}
