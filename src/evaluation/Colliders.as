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
         * @param name one of Settings.COLLIDERS
         * @param greatLand has the models
         */
        public static function make(name:String, greatLand:GreatLand):CollisionSystem
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
                    throw new ArgumentError("there is no collider \"" + name + "\"");
            }
        }
    }
}
