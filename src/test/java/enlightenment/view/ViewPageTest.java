package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.browser.Browser;
import enlightenment.listen.ServerLog;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** The page of a view in a real browser. */
@Timeout(60)
class ViewPageTest {
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
                             "material": { "type": "matte", "color": "#ffffff" } } ]
            }
            """;

    @TempDir
    private Path folder;

    private Path file;
    private LiveView view;

    @BeforeEach
    void open() throws Exception {
        file = Files.writeString(folder.resolve("scene.json"), SCENE);
        SceneSource source = new FileSource(file);
        LiveView.Options options = new LiveView.Options("<b>scene</b>", 0, 2, 2);
        view = LiveView.start(source, FileSource.FILES, options, new ServerLog(line -> {}, System::nanoTime));
        ViewedPage.open(browser, view.address());
        ViewedPage.untilFinished(browser);
    }

    @AfterEach
    void close() throws Exception {
        view.close();
    }

    private static void press(String key, boolean withShift) throws Exception {
        browser.value("document.querySelector('#stage').dispatchEvent(new KeyboardEvent('keydown', { key: '" + key
                + "', shiftKey: " + withShift + ", bubbles: true })); 0");
    }

    @Test
    void aPictureIsShownAsLargeAsTheWindowAllowsAndLoadsNothingFromElsewhere() throws Exception {
        assertEquals("<b>scene</b>", browser.text("#title"));
        browser.until("document.querySelector('#picture').width == document.querySelector('#stage').clientWidth"
                + " || document.querySelector('#picture').height == document.querySelector('#stage').clientHeight");
        String origin = view.address().split("#")[0];
        assertTrue(
                browser.requests().stream().allMatch(r -> r.startsWith(origin)),
                browser.requests().toString());
        assertEquals(List.of(), browser.problems());
    }

    @Test
    void keysMoveTheCameraAndTheButtonWritesIt() throws Exception {
        assertTrue(browser.value("document.querySelector('#save').disabled").asBoolean());
        String before = browser.value("document.querySelector('#picture').src").asString();
        press("-", false);
        browser.until("document.querySelector('#picture').src != '" + before + "'");
        browser.until("!document.querySelector('#save').disabled");
        browser.value("document.querySelector('#save').click(); 0");
        browser.until("document.querySelector('#note').textContent == 'saved'");
        Vector eye = Vector.of(SceneReader.read(file));
        assertTrue(eye.z < -5 && eye.x == 0, eye.toString());
        press("ArrowRight", false);
        browser.until("!document.querySelector('#save').disabled");
        browser.value("document.querySelector('#reset').click(); 0");
        browser.until("document.querySelector('#save').disabled");
    }

    private record Vector(double x, double z) {
        static Vector of(Scene scene) {
            return new Vector(
                    scene.camera().origin().toVec3().x(),
                    scene.camera().origin().toVec3().z());
        }
    }

    @Test
    void draggingToTheRightTurnsTheSceneToTheRight() throws Exception {
        browser.call("Input.dispatchMouseEvent", mouse("mousePressed", 100));
        browser.call("Input.dispatchMouseEvent", mouse("mouseMoved", 130));
        browser.call("Input.dispatchMouseEvent", mouse("mouseReleased", 130));
        browser.until("!document.querySelector('#save').disabled");
        browser.value("document.querySelector('#copy').click(); 0");
        browser.until("document.querySelector('#camera').textContent != ''");
        // Things move to the right if the camera goes to the left.
        double x = browser.value("JSON.parse(document.querySelector('#camera').textContent).eye[0]")
                .asDouble();
        assertTrue(x < 0, "eye at x = " + x);
    }

    private static String mouse(String type, int x) {
        return "{\"type\":\"" + type + "\",\"x\":" + x
                + ",\"y\":100,\"button\":\"left\",\"buttons\":1,\"clickCount\":1}";
    }

    @Test
    void thePixelInTheMiddleIsTheBall() throws Exception {
        press("Enter", false);
        browser.until("document.querySelector('#facts').textContent.includes('ball, object 0 (sphere)')");
    }

    @Test
    void aMistakeIsShownOverTheLastGoodPicture() throws Exception {
        Files.writeString(file, SCENE.replace("\"radius\": 1,", "\"radius\": -1,"));
        Files.setLastModifiedTime(file, FileTime.fromMillis(0));
        browser.until("!document.querySelector('#problem').hidden"
                + " && document.querySelector('#problem').textContent.includes('scene.json:6:')");
        assertTrue(browser.value(
                        "document.querySelector('#picture').naturalWidth > 0 && !document.querySelector('#picture').hidden")
                .asBoolean());
    }

    @Test
    void thePageFitsOnAPhone() throws Exception {
        browser.call(
                "Emulation.setDeviceMetricsOverride",
                "{\"width\":320,\"height\":600,\"deviceScaleFactor\":1,\"mobile\":true}");
        try {
            browser.open(view.address().replace("/#", "/?phone#"));
            ViewedPage.untilFinished(browser);
            assertEquals(
                    320, browser.value("document.scrollingElement.scrollWidth").asInt());
        } finally {
            browser.call("Emulation.clearDeviceMetricsOverride", "{}");
        }
    }

    @Test
    void withoutItsKeyThePageSaysSo() throws Exception {
        browser.open(view.address().split("#")[0] + "?none");
        browser.until("document.readyState == 'complete'"
                + " && document.querySelector('#note').textContent.startsWith('The key is missing or wrong')");
    }
}
