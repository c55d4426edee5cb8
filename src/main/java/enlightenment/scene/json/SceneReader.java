package enlightenment.scene.json;

import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads scene files.
 *
 * <p>The reader is strict, and it does not stop at the first mistake: a {@link SceneException} lists everything that is
 * wrong with a file, each with line, column and JSON pointer, what was found and what was expected.
 */
public final class SceneReader {
    private static final long MAX_BYTES = 1L << 30;

    private SceneReader() {}

    /**
     * Reads a scene as it stands in the file; an animation has no influence on its numbers.
     *
     * @throws SceneException where the file cannot be read or is no valid scene
     */
    public static Scene read(Path file) {
        return read(file, null);
    }

    /**
     * Reads a scene as it is in one frame of its animation: the numbers that the tracks name are interpolated, exactly,
     * before they are used.
     *
     * @param frame 0 or more, less than the animation's number of frames
     * @throws SceneException where the file cannot be read, is no valid scene, has no animation or no such frame
     */
    public static Scene read(Path file, int frame) {
        return read(file, Integer.valueOf(frame));
    }

    /**
     * Reads a scene from text.
     *
     * @param json the scene
     * @param baseFolder the folder that the paths of textures start at
     * @param displayName what problems call the file
     * @throws SceneException where it is no valid scene
     */
    public static Scene readString(String json, Path baseFolder, String displayName) {
        return parse(json, baseFolder, new Problems(displayName, null), null);
    }

    /** The same, in one frame of its animation; see {@link #read(Path, int)}. */
    public static Scene readString(String json, Path baseFolder, String displayName, int frame) {
        return parse(json, baseFolder, new Problems(displayName, frame), frame);
    }

    private static Scene read(Path file, Integer frame) {
        Problems problems = new Problems(file.toString(), frame);
        String json = text(file, problems);
        problems.throwIfAny();
        return parse(json, file.toAbsolutePath().getParent(), problems, frame);
    }

    private static Scene parse(String json, Path folder, Problems problems, Integer frame) {
        Node root = TreeReader.read(json, problems);
        Scene scene = null;
        if (root != null) {
            scene = SceneBinder.bind(root, problems, folder.toAbsolutePath(), frame);
        }
        problems.throwIfAny();
        return scene;
    }

    private static String text(Path file, Problems problems) {
        String expected = "must be a readable scene file, but ";
        String found;
        try {
            if (!Files.exists(file)) {
                found = "there is no such file";
            } else if (!Files.isRegularFile(file)) {
                found = Files.isDirectory(file) ? "is a folder" : "is not a regular file";
            } else if (Files.size(file) > MAX_BYTES) {
                found = "has " + Files.size(file) + " bytes; the most is " + MAX_BYTES;
            } else {
                return decode(Files.readAllBytes(file), problems);
            }
        } catch (IOException e) {
            found = "cannot be read: " + e.getClass().getSimpleName();
        }
        problems.add(0, 0, "", expected + found);
        return null;
    }

    private static String decode(byte[] bytes, Problems problems) {
        boolean marked = bytes.length >= 3
                && (bytes[0] & 0xff) == 0xef
                && (bytes[1] & 0xff) == 0xbb
                && (bytes[2] & 0xff) == 0xbf;
        int from = marked ? 3 : 0;
        String text = new String(bytes, from, bytes.length - from, StandardCharsets.UTF_8);
        // Only text that shows the replacement character can have been malformed.
        if (text.indexOf('\uFFFD') >= 0) {
            checkUtf8(bytes, problems);
        }
        return text;
    }

    private static void checkUtf8(byte[] bytes, Problems problems) {
        CharsetDecoder decoder = StandardCharsets.UTF_8
                .newDecoder()
                .onMalformedInput(CodingErrorAction.REPORT)
                .onUnmappableCharacter(CodingErrorAction.REPORT);
        ByteBuffer in = ByteBuffer.wrap(bytes);
        if (!decoder.decode(in, java.nio.CharBuffer.allocate(bytes.length), true)
                .isError()) {
            return;
        }
        String before = new String(bytes, 0, in.position(), StandardCharsets.UTF_8);
        int line = 1;
        int start = 0;
        for (int i = before.indexOf('\n'); i >= 0; i = before.indexOf('\n', start)) {
            line++;
            start = i + 1;
        }
        int found = bytes[in.position()] & 0xff;
        problems.add(
                line,
                before.length() - start + 1,
                "",
                "must be text in UTF-8, but contains the byte 0x" + Integer.toHexString(found));
    }
}
