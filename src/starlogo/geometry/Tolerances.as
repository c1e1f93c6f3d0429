package starlogo.geometry
{
    /**
     * The engine's tolerances, as far as several classes share them. Each says what it limits, in which unit, and what happens if it is smaller or
     * larger. A tolerance that one class has alone stands in that class.
     *
     * <p>Nearly all are relative, so games of any scale behave in the same way. They come from two rounding errors: 1.1e-16 relative for a
     * Number, and 6e-8 relative for Flash Player's single-precision Matrix3D.</p>
     */
    public final class Tolerances
    {
        /**
         * How far a point may lie outside of a structure that contains it, as a fraction of the structure's largest extent from its
         * middle. Smaller than 2e-7: a structure may exclude a vertex that was transformed by the same single-precision matrix as the
         * structure. Larger: a fit may leave more of a model outside.
         */
        public static const CONTAINMENT:Number = 1e-6;

        /**
         * The rounding error of a computed position or distance, as a fraction of the coordinates. Smaller: two structures that touch to
         * the last bit may get extents that do not overlap. Larger: extents are wider, and more pairs are tested.
         */
        public static const ROUNDING:Number = 1e-14;

        /**
         * How much the dot products of a rotation's columns, or of a box's axes, may differ from 1 and 0. Of a matrix with one scale, the columns
         * divided by it are compared. Smaller than 5e-7: matrices are refused that Flash Player has rounded to single precision. Larger: a scaled
         * matrix passes for a rotation, and shear and uneven scale go unnoticed.
         */
        public static const ORTHONORMALITY:Number = 1e-5;

        /**
         * The difference up to which two numbers from single-precision matrices count as equal, as a fraction of the largest. An Away3D
         * object's three scales are such numbers. Smaller than 5e-7: objects that were loaded with a matrix are refused. Larger: objects
         * of uneven scale pass, and the drawn object differs from the shape that collides.
         */
        public static const SINGLE_PRECISION:Number = 1e-5;

        /**
         * The gap across which shapes touch because their positions are rounded, as a fraction of the sum of the absolute values of all six
         * coordinates. Every collision system has this rule, for standing, sweeping and questions. Smaller than 2.3e-16: shapes at decimal
         * coordinates that touch do not collide. Larger: far from the origin, shapes with a gap collide.
         */
        public static const PLACES:Number = 6e-16;

        /**
         * The factor on the distance at which two structures touch: 1 plus the rounding of a test in several steps. It must be at least 1 +
         * 4 SURFACES. Smaller: rotated structures that touch do not collide. Larger: structures with a gap collide.
         */
        public static const TOUCHING:Number = 1 + 4e-14;

        /**
         * The squared sine of the angle below which two directions are nearly parallel. Their products are then computed from cross
         * products, where no digits cancel. Smaller: answers lose digits, because their error is 1e-16 divided by the sine of the angle.
         * Larger: more pairs take the slower computation, with the same answers.
         */
        public static const NEARLY_PARALLEL:Number = 1e-6;

        /**
         * The squared sine of the angle below which two directions are parallel. Smaller: rounding gives parallel directions a cross
         * product. Larger than 1e-20: boxes collide across a gap of the angle times their length.
         */
        public static const PARALLEL:Number = 1e-28;

        /**
         * The number up to which lengths, heights and determinants are rounding, where shapes have a size of about 1. Smaller: rounding
         * decides how a hull loses corners, and flat sides of a hull have edges inside. Larger: short edges and shallow ones are lost.
         */
        public static const UNIT_ROUNDING:Number = 1e-12;

        /**
         * The gap across which the surfaces of two models touch, as a fraction of the sum of the radii of spheres around both. The nodes of
         * hierarchies and the fitted boxes and capsules are enlarged by it. Smaller than 2e-15: rotated surfaces that touch do not collide.
         * Larger: surfaces with a gap collide.
         */
        public static const SURFACES:Number = 1e-14;

        /**
         * The rounding of the distance of two convex cores, as a fraction of the sum of their extents. It is part of the distance at which they
         * touch: see Touching. Smaller than 4e-16: shapes that touch do not collide if one of them is much larger than the gaps of the two. Larger:
         * shapes with a gap collide.
         */
        public static const CORES:Number = 1e-15;

        /**
         * How much larger a hierarchy's nodes are than the nodes of the next level, as a fraction of the model's radius. Smaller than
         * 1e-15: because of rounding, children may touch something that their parents do not touch, so a greater depth may find more
         * collisions than a smaller depth. Larger: nodes are larger, by 63 times that fraction at the root.
         */
        public static const NESTING:Number = 2e-15;

        /**
         * From this level on, a hierarchy's nodes are not larger than the nodes of the next level: see NESTING. Smaller: below that
         * level, a greater depth may find more collisions than a smaller depth. Larger: all nodes are larger, by NESTING for each level.
         */
        public static const NESTED_LEVELS:int = 64;

        /**
         * The distance below which corners of triangles count as one for the surface as a whole, as a fraction of the model's extent. ROUNDING
         * of the largest coordinate is added. Smaller than 2.1e-7: seams between corners that were rounded to single precision stay open,
         * and the model has no inside. Larger: small holes are closed.
         */
        public static const WELDING:Number = 2.5e-7;

        /**
         * The least sine of an angle between directions of contacts that rounding leaves certain. Edges within this angle count as parallel to
         * each other or to a face. As a fraction of the structures' size it is a length: a gap that is longer has a certain direction, so the
         * normal is along it, and corners whose depths differ by less touch together. Smaller: normals have an error of 1e-16 divided by it.
         * Larger: depths have an error of that fraction.
         */
        public static const DIRECTION:Number = 1e-9;

        /**
         * The largest difference between two computations of the same time of impact, as a fraction of the motion. Of the triangles that touch
         * within it, the one that the motion meets most squarely makes the contact. Smaller: because of rounding, a side that a motion
         * grazes may make the contact. Larger: a later touch may replace the first one.
         */
        public static const SAME_TIME:Number = 1e-9;

        /**
         * How far a contact's depth may be off, as a fraction of the larger of the two extents. If the two are moved apart by the depth
         * plus this, they do not touch. If they are moved apart by the depth minus this, they touch. Smaller than 1e-12: rounding errors
         * along directions nearly parallel to a surface are larger. Larger: contacts are less precise.
         */
        public static const SEPARATION:Number = 1e-9;

        /**
         * The factor that enlarges the shapes of quick tests, which come before the deciding test. Smaller than 1 + 1e-14: because of
         * rounding, quick tests may separate shapes that touch. Larger: quick tests decide fewer pairs.
         */
        public static const OUTER:Number = 1 + 1e-12;

        /**
         * Questions find an agent, and a structure's node meets others, by a box that is larger by this fraction of the size. Smaller than
         * 1e-14: agents that touch because of rounding may not be found. Larger: more agents are tested.
         */
        public static const EXTENTS:Number = 1e-13;
    }
}
