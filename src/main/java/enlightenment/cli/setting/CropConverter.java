package enlightenment.cli.setting;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WholeNumber;
import enlightenment.scene.RenderSettings.Crop;
import picocli.CommandLine.ITypeConverter;

/** Reads {@code X,Y,WIDTH,HEIGHT}; whether that lies in the picture is seen when its size is known. */
final class CropConverter implements ITypeConverter<Crop> {
    @Override
    public Crop convert(String text) {
        int[] crop = WholeNumber.several(text, ",", 4);
        if (crop == null) {
            throw BadValue.expected("X,Y,WIDTH,HEIGHT, four whole numbers in pixels such as 0,0,100,50", text);
        }
        return new Crop(crop[0], crop[1], crop[2], crop[3]);
    }

    /** A crop as it is typed. */
    static String typed(Crop c) {
        return c.x() + "," + c.y() + "," + c.width() + "," + c.height();
    }
}
