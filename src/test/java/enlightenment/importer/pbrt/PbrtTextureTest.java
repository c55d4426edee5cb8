package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Image textures of pbrt that are made anew. */
class PbrtTextureTest {
    @TempDir
    private Path folder;

    private SceneImporter.Result read(String text) throws IOException {
        Path file = folder.resolve("scene.pbrt");
        Files.writeString(file, text);
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT.withExtracted(folder.resolve("made")));
    }

    private static final double STEP = 1.0 / 65535;

    /** Red, green and blue are as they stand in the file. */
    private Material material(String texture, String material) throws IOException {
        ImageFiles.writePng(new Image(1, 1, new float[] {0.2f, 0.4f, 0.6f}), folder.resolve("p.png"));
        SceneImporter.Result s =
                read("WorldBegin Texture \"t\" " + texture + " Material " + material + " Shape \"sphere\"");
        assertEquals(List.of(), s.notes());
        return s.scene().objects().get(0).material();
    }

    private static void assertPixel(double r, double g, double b, Texture texture) throws IOException {
        Texture.File file = (Texture.File) texture;
        assertEquals(Texture.Encoding.LINEAR, file.encoding());
        Image image = ImageFiles.read(file.file());
        assertEquals(r, image.component(0, 0, 0), STEP);
        assertEquals(g, image.component(0, 0, 1), STEP);
        assertEquals(b, image.component(0, 0, 2), STEP);
    }

    private static final String COLORS = "\"spectrum\" \"imagemap\" \"string filename\" \"p.png\"";
    private static final String NUMBERS =
            "\"float\" \"imagemap\" \"string filename\" \"p.png\" \"string encoding\" \"linear\"";
    private static final String DIFFUSE = "\"diffuse\" \"texture reflectance\" \"t\"";

    @Test
    void aPlainImageStaysItsFile() throws IOException {
        Texture t = material(COLORS, DIFFUSE).color();
        assertEquals(new Texture.File(folder.resolve("p.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB), t);
    }

    @Test
    void scalesAreMultipliedIntoLinearLight() throws IOException {
        Texture t = material(COLORS + " \"float scale\" .5", DIFFUSE).color();
        assertPixel(linear(51) / 2, linear(102) / 2, linear(153) / 2, t);
    }

    @Test
    void anInvertedImageIsOneMinusItsScaledLight() throws IOException {
        Texture t = material(COLORS + " \"float scale\" 2 \"bool invert\" true", DIFFUSE)
                .color();
        assertPixel(1 - 2 * linear(51), 1 - 2 * linear(102), 1 - 2 * linear(153), t);
    }

    private static double linear(int byteOf) {
        return TransferCurve.decode(byteOf / 255.0);
    }

    @Test
    void texturedRoughnessIsTheRootOfAlphaAtEachPlace() throws IOException {
        double mean = 0.4;
        for (boolean isRemapped : List.of(false, true)) {
            String p = " \"texture roughness\" \"t\" \"bool remaproughness\" " + isRemapped;
            double expected = StrictMath.pow(mean, isRemapped ? 0.25 : 0.5);
            Texture.Amount.Textured coat =
                    (Texture.Amount.Textured) ((Coated) material(NUMBERS, "\"coateddiffuse\"" + p)).roughness();
            assertPixel(expected, expected, expected, coat.texture());
            Files.delete(((Texture.File) coat.texture()).file());
            Texture.Amount.Textured metal =
                    (Texture.Amount.Textured) ((Glossy) material(NUMBERS, "\"conductor\"" + p)).roughness();
            assertPixel(expected, expected, expected, metal.texture());
            Files.delete(((Texture.File) metal.texture()).file());
            Texture.Amount.Textured glass =
                    (Texture.Amount.Textured) ((Glass) material(NUMBERS, "\"dielectric\"" + p)).roughness();
            assertPixel(expected, expected, expected, glass.texture());
            Files.delete(((Texture.File) glass.texture()).file());
        }
    }
}
