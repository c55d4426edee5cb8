package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.importer.SceneImporter;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that are broken, or want to do harm, are refused by one line that names file and line. */
class PbrtHostileTest {
    private static final String SCENE = "LookAt 3 4 1.5 .5 .5 0 0 0 1\nCamera \"perspective\" \"float fov\" 45\n"
            + "Film \"rgb\" \"integer xresolution\" [60] \"integer yresolution\" [40]\nWorldBegin\n"
            + "Texture \"c\" \"spectrum\" \"checkerboard\" \"float uscale\" [4] \"rgb tex1\" [.1 .1 .1]\n"
            + "MakeNamedMaterial \"m\" \"string type\" \"diffuse\" \"texture reflectance\" \"c\"\n"
            + "AttributeBegin\nNamedMaterial \"m\"\nAreaLightSource \"diffuse\" \"blackbody L\" 3500\n"
            + "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\nAttributeEnd\n"
            + "ObjectBegin \"o\" Shape \"sphere\" \"float radius\" 2 ObjectEnd ObjectInstance \"o\"\n"
            + "Shape \"loopsubdiv\" \"integer levels\" 1 \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n"
            + "Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1] Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"\n"
            + "Shape \"disk\" \"float innerradius\" .5 # end\n";

    @TempDir
    private Path folder;

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    private String refusal(String text) throws IOException {
        write("scene.pbrt", text);
        return refusal();
    }

    private String refusal() {
        SceneException e = assertThrows(
                SceneException.class,
                () -> SceneImporter.read(folder.resolve("scene.pbrt"), SceneImporter.Options.DEFAULT));
        assertEquals(1, e.problems().size());
        String text = e.problems().get(0).toString();
        assertFalse(text.contains("\n"), text);
        return text;
    }

    private void assertRefused(String text, int line, String part) throws IOException {
        String refusal = refusal(text);
        assertTrue(refusal.contains("scene.pbrt:" + line) && refusal.contains(part), refusal);
    }

    @Test
    void whatIsNoSceneIsRefusedAtItsLine() throws IOException {
        assertRefused("WorldBegin\nShpae \"sphere\"", 2, "no directive \"Shpae\"");
        assertRefused("WorldBegin\nShape \"sphere\" \"float radius\" [ 1 2 ]", 2, "one number");
        assertRefused("WorldBegin\n\nShape \"sphere\" \"float radius\" -1", 3, "greater than 0");
        assertRefused("WorldBegin\nShape \"sphere\" \"float radius\" [ 1", 2, "no closing bracket");
        assertRefused("WorldBegin\nShape \"sphere", 2, "no closing quotation mark");
        assertRefused("WorldBegin\nAttributeBegin\nShape \"sphere\"", 3, "AttributeBegin has no end");
        assertRefused("WorldBegin\nAttributeEnd", 2, "an end without AttributeBegin");
        assertRefused("WorldBegin\nTranslate 1 2 x", 2, "three numbers");
        assertRefused("WorldBegin\nMaterial \"matte\" Shape \"sphere\"", 2, "pbrt --upgrade");
        assertRefused("WorldBegin\nNamedMaterial \"gone\"\nShape \"sphere\"", 2, "no material named");
        assertRefused("Scale 0 1 1\nCamera \"perspective\"", 2, "no inverse");
        assertRefused(
                "WorldBegin\nShape \"trianglemesh\" \"point3 P\" [0 0 0] \"integer indices\" [0 1 2]", 2, "index");
    }

    @Test
    void filesMustLieBesideTheScene() throws IOException {
        assertRefused("Include \"../other.pbrt\"", 1, "leads out of the folder");
        assertRefused("Include \"/etc/passwd\"", 1, "leads out of the folder");
        assertRefused("WorldBegin\nShape \"plymesh\" \"string filename\" \"http://x/y.ply\"", 2, "is a URL");
        assertRefused("Include \"geometry.pbrt.gz\"", 1, "gunzip");
    }

    @Test
    void circlesOfIncludedFilesAreRefusedWithTheirChain() throws IOException {
        write("a.pbrt", "Include \"b.pbrt\" Shape \"sphere\"");
        write("b.pbrt", "Include \"a.pbrt\" Shape \"sphere\"");
        String refusal = refusal("Include \"a.pbrt\" Shape \"sphere\"");
        assertTrue(refusal.contains("scene.pbrt > a.pbrt > b.pbrt > a.pbrt"), refusal);
    }

    @Test
    void whatRefersToItselfIsRefused() throws IOException {
        assertRefused(
                "WorldBegin\nTexture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"t\"\n"
                        + "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"",
                2,
                "circle");
        assertRefused(
                "WorldBegin\nMakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"]\n"
                        + "NamedMaterial \"m\" Shape \"sphere\"",
                2,
                "circle");
    }

    @Test
    void texturesThatMultiplyAreResolvedOnce() throws IOException {
        StringBuilder text = new StringBuilder("WorldBegin\nTexture \"t0\" \"float\" \"constant\" \"float value\" 1\n");
        for (int i = 1; i <= 60; i++) {
            String before = "\"t" + (i - 1) + "\"";
            text.append("Texture \"t" + i + "\" \"float\" \"scale\" \"texture tex\" " + before + " \"texture scale\" "
                    + before + "\n");
        }
        write("scene.pbrt", text + "Shape \"sphere\" \"texture alpha\" \"t60\"");
        assertEquals(
                1,
                SceneImporter.read(folder.resolve("scene.pbrt"), SceneImporter.Options.DEFAULT)
                        .scene()
                        .objects()
                        .size());
    }

    @Test
    void deepNestingIsRefused() throws IOException {
        assertRefused("AttributeBegin ".repeat(20_000), 1, "nested deeper");
    }

    @Test
    void controlCharactersOfAFileAreNotPrinted() throws IOException {
        assertFalse(refusal("WorldBegin \u001b[31mX").contains("\u001b"));
    }

    /** Each of 2,000 mutations becomes a scene or is refused by one line. */
    @Test
    void mutatedFilesAreReadOrRefusedByOneLine() throws IOException {
        Random random = new Random(39);
        byte[] original = SCENE.getBytes(StandardCharsets.UTF_8);
        String alphabet = "\"[]#-.0123456789eE \nabcPfNsrg\\\u0007";
        int refused = 0;
        for (int i = 0; i < 2000; i++) {
            byte[] bytes = original.clone();
            for (int k = 1 + random.nextInt(4); k > 0; k--) {
                bytes[random.nextInt(bytes.length)] = (byte) alphabet.charAt(random.nextInt(alphabet.length()));
            }
            Files.write(folder.resolve("scene.pbrt"), bytes);
            try {
                SceneImporter.read(folder.resolve("scene.pbrt"), SceneImporter.Options.DEFAULT);
            } catch (SceneException e) {
                refused++;
                assertEquals(1, e.problems().size());
                String text = e.problems().get(0).toString();
                assertTrue(text.contains("scene.pbrt") && !text.contains("\n") && !text.contains("\u0007"), text);
            }
        }
        assertTrue(refused > 500 && refused < 1990, "refused " + refused);
    }
}
