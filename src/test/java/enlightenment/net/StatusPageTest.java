package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.browser.Browser;
import enlightenment.net.secure.Token;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The status page as a browser shows it, after its scripts ran. */
@Timeout(600)
class StatusPageTest {
    @RegisterExtension
    static final Browser browser = new Browser();

    private Farm farm;
    private String origin;

    /** How many tiles the worker may say, so that the page is looked at while nothing changes. */
    private final AtomicInteger allowed = new AtomicInteger();

    /** A worker comes, and says so many tiles. */
    private void work(int tiles) {
        allowed.set(tiles);
        AtomicInteger made = new AtomicInteger();
        farm.join(Farm.worker(1).tamper((tile, bytes) -> {
            int number = made.incrementAndGet();
            Farm.until(() -> number <= allowed.get(), "it may go on");
            return bytes;
        }));
        Farm.until(() -> farm.server.round().snapshot().done() == tiles, "so many tiles are done");
    }

    @BeforeEach
    void server() throws Exception {
        farm = new Farm(Farm.options().statusPort(0)).begin();
        origin = "http://127.0.0.1:" + farm.server.statusPort() + "/";
    }

    @AfterEach
    void end() {
        allowed.set(Integer.MAX_VALUE);
        farm.close();
    }

    private void assertNoFaultAndNothingFromElsewhere() {
        assertEquals(List.of(), browser.problems());
        List<String> requests = browser.requests();
        assertTrue(requests.stream().anyMatch(r -> r.startsWith(origin + "status.json")), requests.toString());
        assertTrue(requests.stream().allMatch(r -> r.startsWith(origin)), requests.toString());
    }

    @Test
    void workersTilesAndPictureAreShownAndKeptUpToDate() throws Exception {
        int shown = 5;
        work(shown);
        browser.open(origin);
        browser.until("document.readyState == 'complete' && document.querySelectorAll('#workers tr').length == 1");
        browser.until("document.querySelector('#picture').naturalWidth > 0");
        int tiles = farm.server.round().job().tiles();
        assertTrue(
                browser.text("#numbers").startsWith(shown + " of " + tiles + " tiles done, "),
                browser.text("#numbers"));
        assertEquals(100 * shown / tiles + " %", browser.text("#state"));
        assertEquals(
                Farm.SETTINGS.region().width(),
                browser.value("document.querySelector('#picture').naturalWidth").asInt());
        assertEquals(
                Farm.SETTINGS.region().height(),
                browser.value("document.querySelector('#picture').naturalHeight")
                        .asInt());
        assertEquals(farm.server.round().snapshot().workers().get(0).name(), browser.text("#workers tr td"));
        assertEquals(
                browser.value("document.querySelectorAll('th').length").asInt(),
                browser.value("document.querySelectorAll('#workers td').length").asInt());
        assertTrue(browser.text("#log").contains("joined with 1 threads"), browser.text("#log"));
        allowed.set(2 * shown);
        browser.until("parseInt(document.querySelector('#numbers').textContent) > " + shown);
        browser.until(
                "last.done > " + shown + " && document.querySelector('#picture').src.includes('n=' + last.picture)");
        assertNoFaultAndNothingFromElsewhere();
    }

    @Test
    void whatAStrangeWorkerCallsItselfIsTextAndNothingElse() throws Exception {
        String name = "<img src=" + origin + "stolen onerror=stolen()>";
        try (RawPeer peer = new RawPeer(farm.server.port())) {
            peer.join(name, Token.NONE);
            browser.open(origin);
            browser.until("document.querySelectorAll('#workers tr').length == 1");
            assertTrue(browser.text("#workers tr td").startsWith(name), browser.text("#workers"));
            assertTrue(browser.text("#log").contains(name), browser.text("#log"));
            assertEquals(1, browser.value("document.images.length").asInt());
            assertFalse(browser.requests().contains(origin + "stolen"));
            assertNoFaultAndNothingFromElsewhere();
        }
    }

    @Test
    void thePolicyKeepsThePageFromAskingElsewhere() throws Exception {
        browser.open(origin);
        browser.until("document.querySelector('#numbers') && document.querySelector('#numbers').textContent != ''");
        assertNoFaultAndNothingFromElsewhere();
        browser.value(
                "document.addEventListener('securitypolicyviolation', e => window.violated = e.violatedDirective);"
                        + "fetch('" + origin.replace("127.0.0.1", "localhost") + "health').catch(e => e); 0");
        browser.until("window.violated == 'connect-src'");
    }

    @Test
    void onANarrowScreenOnlyTheTableScrollsSideways() throws Exception {
        work(1);
        browser.call(
                "Emulation.setDeviceMetricsOverride",
                "{\"width\":320,\"height\":600,\"deviceScaleFactor\":1,\"mobile\":false}");
        try {
            browser.open(origin);
            browser.until("document.querySelectorAll('#workers tr').length == 1");
            int table = browser.value("document.querySelector('#table').scrollWidth")
                    .asInt();
            assertTrue(table > 320, "the table needs " + table);
            assertEquals(
                    320, browser.value("document.scrollingElement.scrollWidth").asInt());
        } finally {
            browser.call("Emulation.clearDeviceMetricsOverride", "{}");
        }
    }

    @Test
    void aServerThatHasEndedIsToldOf() throws Exception {
        browser.open(origin);
        browser.until("document.querySelector('#numbers') && document.querySelector('#numbers').textContent != ''");
        assertEquals("", browser.text("#problem"));
        farm.close();
        browser.until("document.querySelector('#problem').textContent.startsWith('There is no answer')");
    }
}
