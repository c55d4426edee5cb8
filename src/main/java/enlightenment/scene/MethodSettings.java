package enlightenment.scene;

/**
 * The settings of one method, as a record of its own: {@link RayTraceSettings}, {@link ClusterSettings}, or one of an extension.
 * What was chosen of the settings of all methods is a {@link ChosenSettings}.
 *
 * <p>Immutable.
 */
public interface MethodSettings {
    /** Whose settings they are. */
    Method method();

    /** The value of one of the {@link Method#settings}, which this must have. */
    Object value(MethodSetting setting);
}
