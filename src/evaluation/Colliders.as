package evaluation
{
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;

    /** Makes colliders by the names of their classes. */
    public final class Colliders
    {
        /**
         * @param name one of Settings.COLLIDERS, or another class's
         * @param greatLand has the models
         * @param own makes the colliders of other names
         * @throws ArgumentError if there is no such class, or it is not a CollisionSystem
         */
        public static function make(name:String, greatLand:GreatLand, own:OwnClasses = null):CollisionSystem
        {
            switch (name)
            {
                case "BinCollider":
                    return new BinCollider(greatLand);
                case "TightestFitCollider":
                    return new TightestFitCollider(greatLand);
                case "HierarchicalCollider":
                    return new HierarchicalCollider(greatLand);
                case "CombinationCollider":
                    return new CombinationCollider(greatLand);
                default:
                    return (own || new OwnClasses()).collider(name, greatLand);
            }
        }
    }
}
