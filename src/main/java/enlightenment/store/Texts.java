package enlightenment.store;

import enlightenment.image.ImageFiles;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** The texts for a picture's file as bytes: pairs of keyword and text, each as its length and UTF-8. */
final class Texts {
    private static final int MOST = 64;

    private Texts() {}

    static byte[] toBytes(Map<String, String> texts) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            for (Map.Entry<String, String> text : texts.entrySet()) {
                write(out, text.getKey());
                write(out, text.getValue());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static void write(DataOutputStream out, String text) throws IOException {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        out.writeInt(utf8.length);
        out.write(utf8);
    }

    /** The texts in the bytes, without those that are not valid or that no file can have. */
    static Map<String, String> of(byte[] bytes) {
        Map<String, String> texts = new LinkedHashMap<>();
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            while (in.available() > 0 && texts.size() < MOST) {
                String key = read(in);
                String value = read(in);
                if (isComment(key, value)) {
                    texts.put(key, value);
                }
            }
        } catch (IOException e) {
            texts.clear();
        }
        return texts;
    }

    /** Whether a file can have it: a store may come from anybody. */
    private static boolean isComment(String key, String value) {
        try {
            return !ImageFiles.PngOptions.DEFAULT.withText(key, value).text().isEmpty();
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    private static String read(DataInputStream in) throws IOException {
        int length = in.readInt();
        if (length < 0 || length > in.available()) {
            throw new IOException("a text that ends too early");
        }
        return new String(in.readNBytes(length), StandardCharsets.UTF_8);
    }
}
