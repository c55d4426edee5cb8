package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.text.Plain;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What peers say reaches nobody's terminal, log or page as they said it. */
@Timeout(60)
class TextsTest {
    private static final String NASTY =
            "\u001b[2J\u009b31m\r\nenlightenment: done\u202egnp\u0000\u2066" + "x".repeat(5_000);
    private static final ContentHash HASH = ContentHash.of(new byte[1]);

    private static Object value(Class<?> type, String name) {
        if (type == String.class) {
            return name.equals("magic") ? Message.MAGIC : NASTY;
        }
        if (type == byte[].class) {
            return new byte[32];
        }
        if (type == List.class) {
            return List.of();
        }
        return type == ContentHash.class ? HASH : type == boolean.class ? (Object) true : (Object) 1;
    }

    @Test
    void noMessageHoldsATextThatIsNotPlainAndShort() throws Exception {
        int texts = 0;
        for (Class<? extends Message> kind : Message.KINDS) {
            RecordComponent[] components = kind.getRecordComponents();
            if (Arrays.stream(components).noneMatch(c -> c.getType() == String.class)) {
                continue;
            }
            Constructor<? extends Message> constructor = kind.getDeclaredConstructor(
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
            Message message = constructor.newInstance(Arrays.stream(components)
                    .map(c -> value(c.getType(), c.getName()))
                    .toArray());
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            Frames.write(out, message, Limits.FRAME);
            Message read = Frames.read(new ByteArrayInputStream(out.toByteArray()), Limits.FRAME)
                    .orElseThrow();
            for (RecordComponent component : components) {
                if (component.getType() == String.class) {
                    String text = (String) component.getAccessor().invoke(read);
                    assertEquals(Plain.line(text, Limits.TEXT), text, kind + " " + component.getName());
                    texts++;
                }
            }
        }
        assertTrue(texts >= 5, "hello, refusal and good-bye have texts");
    }

    @Test
    void aTextThatCameRawOverTheWireIsPlainWhenItIsRead() throws Exception {
        byte[] good = MessageCodec.encode(new Message.Bye("a?b"));
        good[good.length - 2] = 27;
        assertEquals(new Message.Bye("a?b"), MessageCodec.decode(good));
    }

    @Test
    void logAndStatusShowOneHarmlessLine() throws Exception {
        List<String> lines = new ArrayList<>();
        ServerOptions.Builder options = Farm.options().localThreads(1).awaitWorkers(1, 60);
        try (Farm farm = new Farm(options).begin();
                RawPeer peer = new RawPeer(farm.server.port())) {
            Message.Hello h = RawPeer.hello(NASTY);
            peer.prove(h, Token.NONE);
            Message.Job job = peer.receive(Message.Job.class);
            peer.send(RawPeer.ready(job, NASTY));
            Farm.until(
                    () -> farm.server.round().snapshot().workers().stream()
                            .anyMatch(w -> w.name().startsWith("?[2J")),
                    "it has joined");
            String json = StatusJson.of(farm.server.round().snapshot());
            assertEquals(Plain.lines(json), json);
            peer.send(new Message.Bye(NASTY));
            Farm.until(() -> farm.logHas(" left: "), "it has left");
            lines.addAll(List.copyOf(farm.log));
        }
        for (String line : lines) {
            assertEquals(Plain.line(line, ServerLog.LONGEST_LINE), line);
            assertFalse(line.startsWith("enlightenment: done"));
        }
    }
}
