package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Test;

class WarmUpTest {
    /** The ball in the middle is lit by the other one, and both are seen: what takes part in most renders has run. */
    @Test
    void thePictureShowsALitBallAndALamp() {
        Scene scene = WarmUp.scene();
        Image image = Renderer.render(scene, RenderSettings.of(scene));
        float middle = image.component(scene.width() / 2, scene.height() / 2 - 2, 0);
        assertTrue(middle > 0 && middle < 0.9, "middle " + middle);
        boolean showsLamp = false;
        for (int y = 0; y < scene.height(); y++) {
            for (int x = 0; x < scene.width(); x++) {
                showsLamp |= image.component(x, y, 0) > 0.9;
            }
        }
        assertTrue(showsLamp);
    }
}
