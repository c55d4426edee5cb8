package enlightenment.browser;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/**
 * A real browser without a window, and one page in it: Chromium, spoken to by its DevTools protocol over a pipe (JSON texts that
 * end with a zero byte). It is there for all tests of a class, which are left out where there is none.
 */
public final class Browser implements BeforeAllCallback, AfterAllCallback {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final long PATIENCE_SECONDS = 50;

    private Path profile;
    private Process process;
    private OutputStream out;
    private final AtomicInteger calls = new AtomicInteger();
    private final Map<Integer, CompletableFuture<JsonNode>> answers = new ConcurrentHashMap<>();
    private final List<String> problems = Collections.synchronizedList(new ArrayList<>());
    private final List<String> requests = Collections.synchronizedList(new ArrayList<>());
    private String session;

    /** The first Chromium or Chrome on the path. */
    private static Optional<Path> executable() {
        String path = System.getenv().getOrDefault("PATH", "");
        return Stream.of("chromium", "chromium-browser", "google-chrome")
                .flatMap(name -> Stream.of(path.split(File.pathSeparator)).map(folder -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    @Override
    public void beforeAll(ExtensionContext context) throws Exception {
        Optional<Path> executable = executable();
        assumeTrue(executable.isPresent(), "no Chromium on the path");
        profile = Files.createTempDirectory("browser");
        // The shell makes our pipes those that the browser listens and speaks to: 3 and 4.
        process = new ProcessBuilder(
                        "sh",
                        "-c",
                        "exec \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1",
                        "sh",
                        executable.get().toString(),
                        "--headless",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--no-first-run",
                        "--disable-background-networking",
                        "--remote-debugging-pipe",
                        "--user-data-dir=" + profile,
                        "about:blank")
                .start();
        out = process.getOutputStream();
        Thread reader = new Thread(this::hear, "browser");
        reader.setDaemon(true);
        reader.start();
        String target = call("Target.createTarget", "{\"url\":\"about:blank\"}")
                .get("targetId")
                .asString();
        session = call("Target.attachToTarget", "{\"flatten\":true,\"targetId\":\"" + target + "\"}")
                .get("sessionId")
                .asString();
        for (String domain : new String[] {"Page", "Runtime", "Log", "Network"}) {
            call(domain + ".enable", "{}");
        }
    }

    private void hear() {
        try {
            InputStream in = process.getInputStream();
            ByteArrayOutputStream text = new ByteArrayOutputStream();
            for (int b = in.read(); b >= 0; b = in.read()) {
                if (b > 0) {
                    text.write(b);
                } else {
                    hear(JSON.readTree(text.toByteArray()));
                    text.reset();
                }
            }
        } catch (IOException | RuntimeException e) {
            problems.add("the browser cannot be understood: " + e);
        }
        answers.values().forEach(a -> a.completeExceptionally(new IOException("the browser ended")));
    }

    private void hear(JsonNode message) {
        if (message.has("id")) {
            CompletableFuture<JsonNode> answer =
                    answers.remove(message.get("id").asInt());
            if (answer != null) {
                answer.complete(message);
            }
            return;
        }
        String what = message.path("method").asString("");
        JsonNode about = message.path("params");
        boolean isProblem = what.equals("Runtime.exceptionThrown")
                || (what.equals("Runtime.consoleAPICalled")
                        && !about.path("type").asString("").equals("log"))
                || what.equals("Log.entryAdded");
        if (isProblem) {
            problems.add(about.toString());
        } else if (what.equals("Network.requestWillBeSent")) {
            requests.add(about.path("request").path("url").asString(""));
        }
    }

    /** Has the browser do something; gives the result. */
    public JsonNode call(String method, String parameters) throws Exception {
        int id = calls.incrementAndGet();
        CompletableFuture<JsonNode> answer = new CompletableFuture<>();
        answers.put(id, answer);
        String text = "{\"id\":" + id + ",\"method\":\"" + method + "\",\"params\":" + parameters
                + (session == null ? "" : ",\"sessionId\":\"" + session + "\"") + "}\0";
        synchronized (out) {
            out.write(text.getBytes(StandardCharsets.UTF_8));
            out.flush();
        }
        JsonNode message = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (!message.has("result")) {
            throw new IOException(method + ": " + message);
        }
        return message.get("result");
    }

    /** Goes to a page, and forgets what was noted of those before: they have ended when it begins. */
    public void open(String url) throws Exception {
        call("Page.navigate", "{\"url\":\"about:blank\"}");
        until("location.href == 'about:blank' && document.readyState == 'complete'");
        requests.clear();
        problems.clear();
        call("Page.navigate", "{\"url\":" + JSON.writeValueAsString(url) + "}");
    }

    /** What an expression is in the page. */
    public JsonNode value(String expression) throws Exception {
        JsonNode result = call(
                "Runtime.evaluate",
                "{\"returnByValue\":true,\"expression\":" + JSON.writeValueAsString(expression) + "}");
        if (result.has("exceptionDetails")) {
            throw new IOException(expression + ": " + result);
        }
        return result.path("result").path("value");
    }

    /** The text of the first element that a selector finds. */
    public String text(String selector) throws Exception {
        return value("document.querySelector('" + selector + "').textContent").asString();
    }

    /** Waits until an expression is true in the page. */
    public void until(String expression) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!value(expression).asBoolean(false)) {
            if (System.nanoTime() - end > 0) {
                throw new AssertionError("waited in vain until " + expression + " in "
                        + value("document.documentElement.outerHTML").asString() + problems);
            }
            Thread.sleep(20);
        }
    }

    /** Errors, warnings and exceptions since the page was opened. */
    public List<String> problems() {
        synchronized (problems) {
            return List.copyOf(problems);
        }
    }

    /** The addresses that were asked for since the page was opened. */
    public List<String> requests() {
        synchronized (requests) {
            return List.copyOf(requests);
        }
    }

    @Override
    public void afterAll(ExtensionContext context) throws IOException {
        if (process == null) {
            return;
        }
        try {
            session = null;
            call("Browser.close", "{}");
            process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (Exception e) {
            // Then it is ended from outside.
            problems.add(e.toString());
        }
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        deleteProfile();
    }

    /** What is left of the browser may still be writing there: then the system's temporary folder keeps some of it. */
    private void deleteProfile() throws IOException {
        try (Stream<Path> files = Files.walk(profile)) {
            files.sorted(Collections.reverseOrder())
                    .forEach(file -> file.toFile().delete());
        } catch (java.io.UncheckedIOException e) {
            profile.toFile().deleteOnExit();
        }
    }
}
