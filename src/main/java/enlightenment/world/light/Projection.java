package enlightenment.world.light;

import enlightenment.emitter.PictureProfile;
import enlightenment.material.Texture;
import enlightenment.texture.ImageTexture;

/**
 * The picture of a projector as an intensity profile.
 *
 * @param image its texels as linear light
 * @param isNearest whether texels are constant, not interpolated bilinearly between the centres of four
 */
record Projection(ImageTexture image, boolean isNearest) implements PictureProfile.Picture {
    static Projection of(Texture.File texture, ImageTexture image) {
        return new Projection(image, texture.filter() == Texture.Filter.NEAREST);
    }

    @Override
    public int width() {
        return image.width();
    }

    @Override
    public int height() {
        return image.height();
    }

    @Override
    public void lookUp(double u, double v, double[] rgb) {
        if (isNearest) {
            image.nearest(u, v, rgb);
        } else {
            image.bilinear(u, v, false, rgb);
        }
    }

    @Override
    public double[] identity() {
        long fingerprint = image.fingerprint();
        return new double[] {isNearest ? 1 : 0, (int) (fingerprint >>> Integer.SIZE), (int) fingerprint};
    }
}
