package enlightenment.scene;

import java.util.List;

/**
 * The settings that all methods have in common, beside the number of positions per pixel; pictures depend on each. Scene files,
 * their schema, the command line, reports, protocols and the identity of a picture take them from here.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class CommonSettings {
    /** {@link RenderSettings#seed}. */
    public static final MethodSetting.Whole SEED =
            new MethodSetting.Whole("seed", Long.MIN_VALUE, Long.MAX_VALUE, 0, "seed of the random numbers");

    /** All of them, in the order of help and reports. */
    public static final List<MethodSetting> ALL = List.of(SEED);

    private CommonSettings() {}

    /** Whether one of them has this key: then no method's own may. */
    static boolean has(String key) {
        return ALL.stream().anyMatch(setting -> setting.key().equals(key));
    }
}
