package enlightenment.net.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.text.Plain;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What peers say is made harmless before anybody sees it. */
class MessageTextsTest {
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
}
