package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.geometry.Rectangle;
import enlightenment.importer.SceneImporter;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MitsubaHostileFilesTest {
    @TempDir
    Path folder;

    private MitsubaScenes scenes;

    @BeforeEach
    void scenes() throws IOException {
        scenes = new MitsubaScenes(Files.createDirectory(folder.resolve("scene")));
    }

    private void assertRefused(String content, String... parts) throws IOException {
        String message = scenes.refused(scenes.write("scene.xml", content));
        for (String part : parts) {
            assertTrue(message.contains(part), message);
        }
    }

    @Test
    void documentTypesAndEntitiesAreRefused() throws IOException {
        String bomb = "<!DOCTYPE scene [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n";
        assertRefused(bomb + "<scene version=\"3.0.0\">&b;</scene>", "scene.xml:1", "document type");
        assertRefused("<!DOCTYPE scene SYSTEM \"file:///etc/passwd\">\n<scene version=\"3.0.0\"/>", "document type");
        assertRefused("<scene version=\"3.0.0\">\n&b;</scene>", "scene.xml:2");
    }

    @Test
    void includesStayInTheFolder() throws IOException {
        Files.writeString(folder.resolve("outside.xml"), "<scene version=\"3.0.0\"/>");
        for (String name :
                new String[] {"../outside.xml", folder.resolve("outside.xml").toString()}) {
            assertRefused(
                    "<scene version=\"3.0.0\">\n<include filename=\"" + name + "\"/></scene>",
                    "scene.xml:2",
                    "leads out of the folder");
        }
        assertRefused("<scene version=\"3.0.0\"><include filename=\"http://example.org/a.xml\"/></scene>", "is a URL");
    }

    @Test
    void filesElsewhereAreReadFromTheFolderOfAssetsOnly() throws IOException {
        Path scene = Files.createDirectories(folder.resolve("a/scene")).resolve("scene.xml");
        Path shared = Files.createDirectories(folder.resolve("a/shared"));
        Files.writeString(shared.resolve("part.xml"), "<scene version=\"3.0.0\"><shape type=\"sphere\"/></scene>");
        Files.writeString(shared.resolve("part.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        String mesh = "<path value=\"../shared\"/>"
                + "<shape type=\"obj\"><string name=\"filename\" value=\"part.obj\"/></shape>";
        for (String inside : new String[] {"<include filename=\"../shared/part.xml\"/>", mesh}) {
            Files.writeString(scene, "<scene version=\"3.0.0\">" + inside + "</scene>");
            for (Path allowed : new Path[] {shared, folder, shared.resolve("../shared")}) {
                assertTrue(hasObjects(scene, SceneImporter.Options.DEFAULT.withAssets(allowed)));
            }
            SceneImporter.Options others = SceneImporter.Options.DEFAULT.withAssets(shared.resolve("below"));
            for (SceneImporter.Options refused : new SceneImporter.Options[] {SceneImporter.Options.DEFAULT, others}) {
                SceneException e = assertThrows(SceneException.class, () -> hasObjects(scene, refused));
                assertTrue(e.getMessage().contains("leads out of the folder of the scene"), e.getMessage());
            }
        }
    }

    @Test
    void aFolderOfAssetsThatIsNoneIsRefused() throws IOException {
        Path scene = scenes.write("scene.xml", "<scene version=\"3.0.0\"><shape type=\"sphere\"/></scene>");
        for (Path wrong : new Path[] {folder.resolve("nowhere"), scene}) {
            CliRun run = CliRun.of("convert", scene, folder.resolve("scene.json"), "--assets", wrong);
            assertEquals(2, run.code());
            assertTrue(run.err().contains("--assets: there is no folder"), run.err());
        }
    }

    private static boolean hasObjects(Path scene, SceneImporter.Options options) throws IOException {
        Scene read = SceneImporter.read(scene, options).scene();
        return read.objects().stream().anyMatch(o -> !(o.shape() instanceof Rectangle));
    }

    @Test
    void includesInACircleAreRefusedWithTheChain() throws IOException {
        scenes.write("a.xml", "<scene version=\"3.0.0\"><include filename=\"b.xml\"/></scene>");
        scenes.write("b.xml", "<scene version=\"3.0.0\">\n\n<include filename=\"a.xml\"/></scene>");
        assertRefused(
                "<scene version=\"3.0.0\"><include filename=\"a.xml\"/></scene>",
                "b.xml:3",
                "scene.xml -> a.xml -> b.xml -> a.xml");
    }

    @Test
    void deepNestingIsRefused() throws IOException {
        assertRefused("<scene version=\"3.0.0\">" + "<bsdf>".repeat(100_000), "nested deeper than 64");
    }

    @Test
    void whatIsNoXmlIsOneLineWithItsPlace() throws IOException {
        assertRefused("<scene version=\"3.0.0\">\n<shape type=\"sphere\">\n</scene>", "scene.xml:3", "is no XML");
        assertRefused("", "is no XML");
        assertRefused("<html/>", "is no scene of Mitsuba");
    }

    @Test
    void bsdfsAndInstancesInsideOfThemselvesAreRefused() throws IOException {
        assertRefused(
                "<scene version=\"3.0.0\"><bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>"
                        + "<shape type=\"sphere\"><ref id=\"a\"/></shape></scene>",
                "inside of itself");
        assertRefused(
                "<scene version=\"3.0.0\"><shape type=\"shapegroup\" id=\"g\"><shape type=\"instance\"><ref"
                        + " id=\"g\"/></shape></shape><shape type=\"instance\"><ref id=\"g\"/></shape></scene>",
                "inside of itself");
    }

    @Test
    void brokenValuesAreNamedWithTheirLine() throws IOException {
        String sphere = "<scene version=\"3.0.0\">\n<shape type=\"sphere\">\n%s</shape></scene>";
        assertRefused(sphere.formatted("<float name=\"radius\" value=\"x\"/>"), ":3", "finite number", "\"x\"");
        assertRefused(sphere.formatted("<float name=\"radius\" value=\"-0\"/>"), ":2", "sphere");
        assertRefused(sphere.formatted("<ref id=\"gone\"/>"), ":3", "\"gone\"");
        assertRefused(sphere.formatted("<float name=\"radius\" value=\"$r\"/>"), ":3", "\"$r\"");
        assertRefused(
                sphere.formatted("<transform name=\"to_world\"><matrix value=\"1 2 3\"/></transform>"),
                ":3",
                "16 numbers");
        assertRefused(sphere.formatted("<bsdf type=\"mask\"/>"), ":3", "needs 1 bsdf");
    }

    @Test
    void controlCharactersOfAFileAreNotPrinted() throws IOException {
        String message = scenes.refused(scenes.write(
                "scene.xml",
                "<scene version=\"3.0.0\"><shape type=\"sphere\"><ref id=\"a&#x202E;b\"/></shape></scene>"));
        assertEquals(-1, message.indexOf('\u202e'), message);
    }

    @Test
    void exponentialInstancesAreRefused() throws IOException {
        StringBuilder xml = new StringBuilder(
                "<scene version=\"3.0.0\"><shape type=\"shapegroup\" id=\"g0\"><shape type=\"sphere\"/></shape>");
        for (int i = 1; i < 15; i++) {
            xml.append("<shape type=\"shapegroup\" id=\"g").append(i).append("\">");
            xml.append(("<shape type=\"instance\"><ref id=\"g" + (i - 1) + "\"/></shape>").repeat(10))
                    .append("</shape>");
        }
        xml.append("<shape type=\"instance\"><ref id=\"g14\"/></shape></scene>");
        assertRefused(xml.toString(), "more than");
    }
}
