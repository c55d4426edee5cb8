package enlightenment.world.material;

import enlightenment.color.Rgb;
import enlightenment.material.Texture;

/**
 * An amount ready to be looked up. Immutable.
 *
 * @param map where its numbers come from
 * @param channel which component of its colours
 * @param factor what that is multiplied by
 */
public record AmountLookup(TextureLookup map, Texture.Amount.Channel channel, double factor) {

    /** One number everywhere. */
    public static AmountLookup of(Texture.Amount.Constant amount) {
        return mean(new TextureLookup(Texture.of(Rgb.gray(amount.value())), null, true));
    }

    /** The mean of a texture's components. */
    static AmountLookup mean(TextureLookup map) {
        return new AmountLookup(map, Texture.Amount.Channel.MEAN, 1);
    }

    /** The amount of a colour. */
    double of(double[] rgb) {
        return factor
                * switch (channel) {
                    case MEAN -> (rgb[0] + rgb[1] + rgb[2]) / 3;
                    case RED -> rgb[0];
                    case GREEN -> rgb[1];
                    case BLUE -> rgb[2];
                };
    }

    /** A text that is equal for amounts that are the same everywhere. */
    String look() {
        return map.look() + (channel == Texture.Amount.Channel.MEAN && factor == 1 ? "" : " " + channel + " " + factor);
    }
}
