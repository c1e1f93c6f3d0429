package evaluation
{
    import evaluation.literal.LiteralBinCollider;
    import evaluation.literal.LiteralCombinationCollider;
    import evaluation.literal.LiteralHierarchicalCollider;
    import evaluation.literal.LiteralTightestFitCollider;
    import starlogo.GreatLand;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.Model;

    /** For each collider, the thesis's own algorithm, written literally. */
    public final class LiteralColliders
    {
        private var _bins:LiteralBinCollider = new LiteralBinCollider();
        private var _tightest:LiteralTightestFitCollider;
        private var _hierarchical:LiteralHierarchicalCollider;
        private var _combination:LiteralCombinationCollider;

        /**
         * @param greatLand has the tightest fits
         * @param models the models whose hierarchies are built
         */
        public function LiteralColliders(greatLand:GreatLand, models:Array)
        {
            _tightest = new LiteralTightestFitCollider(greatLand.boundingStructures);
            // from vertices alone, as in the thesis
            var hierarchies:HierarchiesLibrary = new HierarchiesLibrary();
            for each (var model:Model in models)
            {
                hierarchies.add(model.name, model.vertices);
            }
            _hierarchical = new LiteralHierarchicalCollider(hierarchies);
            _combination = new LiteralCombinationCollider(_tightest, _hierarchical, hierarchies);
        }

        /**
         * The function that decides whether two agents collide, or null if the thesis has no such collider.
         *
         * @param name the name of a collider's class
         */
        public function pairTest(name:String):Function
        {
            switch (name)
            {
                case "BinCollider":
                    return _bins.areColliding;
                case "TightestFitCollider":
                    return _tightest.areColliding;
                case "HierarchicalCollider":
                    return _hierarchical.areColliding;
                case "CombinationCollider":
                    return _combination.areColliding;
                default:
                    return null;
            }
        }
    }
}
