package enlightenment.method.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.method.Block;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class SeenBlocksTest {
    private static final int SIDE = 8;

    /** A picture of 10 by 10 around the origin of z = 0, with a square plate; 512 by 512 pixels of which each is 10/512 wide. */
    private static SeenBlocks blocks(double left, double bottom, double size) {
        String plate = String.format(
                java.util.Locale.ROOT,
                "[[%1$f, %2$f, 0], [%1$f, %4$f, 0], [%3$f, %4$f, 0], [%3$f, %2$f, 0]]",
                left,
                bottom,
                left + size,
                bottom + size);
        Scene scene = SceneReader.readString(
                """
                {
                  "image": { "width": 512, "height": 512 },
                  "camera": { "type": "orthographic", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "height": 10 },
                  "shading": { "background": "#204080" },
                  "objects": [ { "type": "rectangle", "corners": PLATE, "material": { "type": "matte", "color": "#808080" } } ]
                }
                """
                        .replace("PLATE", plate),
                Path.of("."),
                "plate");
        RenderSettings settings = RenderSettings.of(scene);
        return SeenBlocks.of(SceneCompiler.compile(scene, settings), settings, SIDE);
    }

    @Test
    void whereAllBlocksShowSomethingThoseThatAreSpreadAreThoseOfThePicture() {
        SeenBlocks all = blocks(-8, -8, 16);
        assertEquals(1, all.share());
        assertEquals(Block.spread(512, 512, SIDE, 100), all.spread(100));
    }

    /** A plate of 1 by 1, 51.2 pixels: 7 or 8 blocks each way, but for what its bounding sphere adds, √2 times as wide. */
    @Test
    void aSmallThingIsInAllOfItsBlocksAndInFewOthers() {
        SeenBlocks few = blocks(1.3, -2.1, 1);
        List<Block> all = few.spread(1000);
        assertEquals(all.size() / 4096.0, few.share(), 1e-12);
        assertTrue(all.size() >= 49 && all.size() <= 121, all.size() + " blocks");
        assertEquals(all.size() / 2.0, few.spread(all.size() / 2).size(), 6);
    }

    @Test
    void nothingIsInNoBlock() {
        SeenBlocks none = blocks(70, 70, 1);
        assertEquals(0, none.share());
        assertEquals(List.of(), none.spread(100));
    }
}
