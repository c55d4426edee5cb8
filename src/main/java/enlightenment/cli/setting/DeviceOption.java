package enlightenment.cli.setting;

import enlightenment.cli.option.BadValue;
import enlightenment.device.DeviceChoice;
import enlightenment.math.InvalidValueException;
import enlightenment.render.RenderRequest;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** The option for a device that takes part in a render. */
public final class DeviceOption {
    @Option(
            names = "--device",
            paramLabel = "DEVICE",
            converter = Word.class,
            description = "what shades samples beside the threads: cpu (nothing), opencl or opencl:N for one of"
                    + " 'devices', or auto; the picture does not depend on it")
    private String device = "cpu";

    public DeviceOption() {}

    /** The word for the device, which {@link DeviceChoice#of} reads. */
    public String word() {
        return device;
    }

    /** The request with the device. */
    public RenderRequest addTo(RenderRequest request) {
        return request.withDevice(device);
    }

    static final class Word implements ITypeConverter<String> {
        @Override
        public String convert(String text) {
            try {
                DeviceChoice.of(text);
                return text;
            } catch (InvalidValueException e) {
                throw BadValue.expected(DeviceChoice.WORDS, text);
            }
        }
    }
}
