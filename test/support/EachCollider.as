package support
{
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;

    /** The four colliders, one of them in exact mode too, by name. */
    public final class EachCollider
    {
        /** The names that <code>make()</code> knows. */
        public static const NAMES:Array = ["bins", "tightest fits", "hierarchies", "triangles", "combinations"];

        /** Those, and combinations in exact mode. */
        public static const ALL_NAMES:Array = NAMES.concat("combinations, exact");

        /** Makes a collider. */
        public static function make(name:String, greatLand:GreatLand):Collider
        {
            switch (name)
            {
                case "bins":
                    return new BinCollider(greatLand);
                case "tightest fits":
                    return new TightestFitCollider(greatLand);
                case "hierarchies":
                    return new HierarchicalCollider(greatLand);
                case "triangles":
                    var exact:HierarchicalCollider = new HierarchicalCollider(greatLand);
                    exact.exact = true;
                    return exact;
                case "combinations":
                    return new CombinationCollider(greatLand);
                case "combinations, exact":
                    var combination:CombinationCollider = new CombinationCollider(greatLand);
                    combination.exact = true;
                    return combination;
                default:
                    throw new ArgumentError("unknown collider: " + name);
            }
        }
    }
}
