package enlightenment.texture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImageTextureTest {
    private static final int WIDTH = 4;
    private static final int HEIGHT = 2;

    @TempDir
    Path folder;

    /** Texel (x, y) has red 20·(x + 4·y), green 255 less that, blue 7. */
    private Path file(int depth) throws IOException {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            rgb[3 * i] = 20 * i / 255f;
            rgb[3 * i + 1] = (255 - 20 * i) / 255f;
            rgb[3 * i + 2] = 7 / 255f;
        }
        Path file = folder.resolve("texture.png");
        ImageFiles.writePng(new Image(WIDTH, HEIGHT, rgb), file, ImageFiles.PngOptions.DEFAULT.withDepth(depth));
        return file;
    }

    private static double[] nearest(ImageTexture image, double u, double v) {
        double[] rgb = new double[3];
        image.nearest(u, v, rgb);
        return rgb;
    }

    private static double red(ImageTexture image, double u, double v, boolean wrapU) {
        double[] rgb = new double[3];
        image.bilinear(u, v, wrapU, rgb);
        return rgb[0] * 255;
    }

    @Test
    void atItsCentreEveryTexelHasItsOwnColour() throws IOException {
        for (int depth : new int[] {8, 16}) {
            ImageTexture image = ImageTexture.read(file(depth));
            assertEquals(WIDTH, image.width());
            assertEquals(HEIGHT, image.height());
            double tolerance = depth == 8 ? 0 : 1e-7; // 16-bit texels are kept as floats
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                double u = (i % WIDTH + 0.5) / WIDTH;
                double v = (i / WIDTH + 0.5) / HEIGHT;
                double[] expected = {20 * i / 255.0, (255 - 20 * i) / 255.0, 7 / 255.0};
                double[] rgb = new double[3];
                image.bilinear(u, v, i % 2 == 0, rgb);
                assertArrayEquals(expected, rgb, tolerance);
                assertArrayEquals(expected, nearest(image, u, v), tolerance);
            }
        }
    }

    @Test
    void theNearestTexelIsTheOneAroundThePlace() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        assertEquals(0, nearest(image, 0, 0)[0]);
        assertEquals(0, nearest(image, Math.nextDown(0.25), Math.nextDown(0.5))[0]);
        assertEquals(20 / 255.0, nearest(image, 0.25, 0)[0]);
        assertEquals(80 / 255.0, nearest(image, 0, 0.5)[0]);
        assertEquals(140 / 255.0, nearest(image, Math.nextDown(1.0), Math.nextDown(1.0))[0]);
    }

    @Test
    void theFarEdgeBelongsToTheLastTexelAndNotToTheFirst() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        assertEquals(140 / 255.0, nearest(image, 1, 1)[0]);
        assertEquals(140, red(image, 1, 1, false), 1e-12);
        assertEquals(0, red(image, 0, 0, false), 1e-12);
    }

    @Test
    void thePictureRepeatsBeyondItsEdges() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        for (double u : new double[] {0.125, 0.3, 0.875}) {
            for (double v : new double[] {0.1, 0.625}) {
                for (int shift : new int[] {-1024, -1, 1, 7}) {
                    assertEquals(nearest(image, u, v)[0], nearest(image, u + shift, v - shift)[0]);
                    assertEquals(red(image, u, v, true), red(image, u + shift, v - shift, true), 1e-9);
                }
            }
        }
    }

    @Test
    void betweenCentresColoursAreWeightedByDistance() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        assertEquals(10, red(image, 0.25, 0.25, false), 1e-12); // half-way between texels 0 and 1
        assertEquals(40, red(image, 0.125, 0.5, false), 1e-12); // half-way between texels 0 and 4
        assertEquals(50, red(image, 0.25, 0.5, false), 1e-12); // the mean of 0, 1, 4 and 5
        assertEquals(35, red(image, 0.125 + 0.75 * 0.25, 0.25 + 0.25 * 0.5, false), 1e-12); // 20·0.75 + 80·0.25
    }

    @Test
    void outermostTexelsReachTheEdgeUnlessThePictureGoesAround() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        assertEquals(0, red(image, 0.01, 0.01, false), 1e-12);
        assertEquals(60, red(image, 0.99, 0.01, false), 1e-12);
        assertEquals(140, red(image, 0.99, 0.99, false), 1e-12);
        assertEquals(30, red(image, 0, 0.25, true), 1e-12); // half-way between texels 3 and 0
        assertEquals(30, red(image, 1, 0.25, true), 1e-12);
        assertEquals(60 - 60 * 0.25, red(image, 0.9375, 0.25, true), 1e-12);
        assertEquals(30, red(image, 0, 0.01, true), 1e-12); // rows never go around
    }

    @Test
    void strangeCoordinatesGiveSomeTexel() throws IOException {
        ImageTexture image = ImageTexture.read(file(8));
        double[] odd = {
            Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300, -1e300, -Double.MIN_VALUE, -1e-17
        };
        for (double t : odd) {
            double[] rgb = nearest(image, t, t);
            assertTrue(rgb[0] >= 0 && rgb[0] <= 140 / 255.0);
            double red = red(image, t, t, true);
            assertTrue(red >= 0 && red <= 140, "at " + t + ": " + red);
        }
    }

    @Test
    void aSingleTexelIsEverywhere() throws IOException {
        Path file = folder.resolve("one.png");
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 0.2f, 0}), file);
        ImageTexture image = ImageTexture.read(file);
        double[] rgb = new double[3];
        for (double t = -2; t <= 2; t += 0.0625) {
            image.bilinear(t, -t, t > 0, rgb);
            assertArrayEquals(new double[] {1, 51 / 255.0, 0}, rgb);
        }
    }

    @Test
    void linearFilesAreEncodedForDisplay() throws IOException {
        for (int depth : new int[] {8, 16}) {
            ImageTexture image = ImageTexture.readLinear(file(depth));
            double[] rgb = nearest(image, 0.3, 0.7);
            assertEquals(TransferCurve.encode(100 / 255.0), rgb[0], 1e-7);
            assertEquals(TransferCurve.encode(155 / 255.0), rgb[1], 1e-7);
        }
        Path file = folder.resolve("ends.png");
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 0, 1}), file);
        assertArrayEquals(new double[] {1, 0, 1}, nearest(ImageTexture.readLinear(file), 0, 0));
    }

    @Test
    void aFloatMapIsNoTexture() throws IOException {
        Path file = folder.resolve("a.pfm");
        ImageFiles.writePfm(new Image(1, 1, new float[3]), file);
        String message =
                assertThrows(IOException.class, () -> ImageTexture.read(file)).getMessage();
        assertTrue(message.contains(file.toString()) && message.contains("PNG, JPEG and BMP"), message);
    }
}
