package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImageFormatTest {
    /**
     * How far JPEG may change the components of a picture of one colour: luma and both chroma are rounded to whole numbers and to steps
     * of 2/8 of them (the mean of a block in a table of quality 95), 0.625 of 255 each. Blue is luma + 1.772 chroma, rounded: 2.2 in all.
     */
    private static final float JPEG_TOLERANCE = 3 / 255f;

    @TempDir
    Path folder;

    @Test
    void everyWrittenFormatIsWrittenUnderEachOfItsNamesAndReadBackAsItself() throws IOException {
        Image colors = new Image(2, 1, new float[] {0, 0.2f, 0.4f, 0.6f, 0.8f, 1});
        Image oneColor = new Image(2, 1, new float[] {0.2f, 0.4f, 0.8f, 0.2f, 0.4f, 0.8f});
        for (ImageFormat format : ImageFormat.written()) {
            Image image = format.isLossy() ? oneColor : colors;
            float tolerance = format.isLossy() ? JPEG_TOLERANCE : 0;
            ByteArrayOutputStream stream = new ByteArrayOutputStream();
            ImageFiles.write(image, stream, format, ImageFiles.PngOptions.DEFAULT);
            for (String extension : format.extensions()) {
                for (String name : List.of("a." + extension, "A.B." + extension.toUpperCase(Locale.ROOT))) {
                    Path file = folder.resolve(name);
                    assertEquals(format, ImageFiles.writtenFormat(file));
                    ImageFiles.write(image, file, ImageFiles.PngOptions.DEFAULT);
                    byte[] bytes = Files.readAllBytes(file);
                    assertArrayEquals(stream.toByteArray(), bytes);
                    byte[] start = Arrays.copyOf(bytes, ImageFormat.SIGNATURE_LENGTH);
                    assertEquals(Optional.of(format), ImageFormat.ofContent(start));
                    // Fifths are fractions of 255 as well.
                    assertArrayEquals(image.toArray(), ImageFiles.read(file).toArray(), tolerance);
                }
            }
        }
    }

    @Test
    void aFormatThatIsOnlyReadIsNotWritten() {
        Image image = new Image(1, 1, new float[3]);
        List<ImageFormat> readOnly =
                Arrays.stream(ImageFormat.values()).filter(f -> !f.isWritten()).toList();
        assertEquals(List.of(ImageFormat.BMP, ImageFormat.HDR), readOnly);
        for (ImageFormat format : readOnly) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            assertThrows(
                    IllegalArgumentException.class,
                    () -> ImageFiles.write(image, out, format, ImageFiles.PngOptions.DEFAULT));
            assertEquals(0, out.size());
            Path file = folder.resolve("a." + format.word());
            assertEquals(Optional.of(format), ImageFormat.ofExtension(file));
            IllegalArgumentException e =
                    assertThrows(IllegalArgumentException.class, () -> ImageFiles.writtenFormat(file));
            assertEquals(
                    "cannot tell how to write " + file + ": the name must end in .png, .jpg, .pfm or .exr",
                    e.getMessage());
        }
    }

    @Test
    void theNameIsAnExtensionAndNoExtensionIsSharedOrTakenFromTheMiddleOfAName() {
        List<String> all = Arrays.stream(ImageFormat.values())
                .flatMap(f -> f.extensions().stream())
                .toList();
        assertEquals(all.size(), all.stream().distinct().count());
        for (ImageFormat format : ImageFormat.values()) {
            assertEquals(format.word(), format.name().toLowerCase(Locale.ROOT));
            assertTrue(format.extensions().contains(format.word())
                    || format.extensions().contains("jpeg"));
        }
        for (String name : List.of("png", "a", "a.", "a.pn", "a.pngs", "a.png.txt", "a.png/b", "", "/")) {
            assertEquals(Optional.empty(), ImageFormat.ofExtension(Path.of(name)), name);
        }
    }

    @Test
    void depthsAreThoseThatOptionsTake() {
        for (int depth : ImageFormat.PNG.depths()) {
            assertEquals(depth, new ImageFiles.PngOptions(depth, java.util.Map.of()).depth());
        }
        for (int depth : ImageFormat.EXR.depths()) {
            assertEquals(depth, ImageFiles.ExrOptions.DEFAULT.withDepth(depth).depth());
        }
        assertEquals(
                ImageFiles.ExrOptions.DEFAULT.depth(), ImageFormat.EXR.depths().get(0));
        for (ImageFormat format : ImageFormat.values()) {
            assertEquals(
                    format == ImageFormat.PFM || format == ImageFormat.HDR,
                    format.depths().isEmpty());
            assertEquals(!format.holdsFloats(), ImageFormat.textures().contains(format));
        }
        assertEquals(
                List.of(ImageFormat.PNG, ImageFormat.JPEG, ImageFormat.PFM, ImageFormat.EXR), ImageFormat.written());
    }

    @Test
    void picturesThatAreWrittenIntoTheRootOfACheckoutAreIgnoredByGit() throws IOException {
        List<String> ignored = Files.readAllLines(Path.of(".gitignore"));
        for (ImageFormat format : ImageFormat.written()) {
            for (String extension : format.extensions()) {
                assertTrue(ignored.contains("/*." + extension), extension);
            }
        }
    }

    @Test
    void contentDecidesNotTheFirstBytesOfAnotherKind() {
        assertEquals(Optional.empty(), ImageFormat.ofContent(new byte[0]));
        for (String text : List.of("P", "PF", "PFx1", "PG\n1", "B", "GIF89a", "\u0089PNG\r\n\u001a")) {
            byte[] start = text.getBytes(StandardCharsets.ISO_8859_1);
            assertEquals(Optional.empty(), ImageFormat.ofContent(start), text);
        }
        for (String text : List.of("PF\n1", "Pf 1")) {
            byte[] start = text.getBytes(StandardCharsets.ISO_8859_1);
            assertEquals(Optional.of(ImageFormat.PFM), ImageFormat.ofContent(start), text);
        }
    }
}
