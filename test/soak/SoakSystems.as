package soak
{
    import evaluation.Colliders;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.TreeCollider;
    import support.BruteForce;

    /** The collision systems of a soak, in turn: new ones, and those of before, which other settings may have now. */
    internal final class SoakSystems
    {
        /** What they are counted as. */
        internal static const NAMES:Array = ["BinCollider", "TightestFitCollider", "HierarchicalCollider", "CombinationCollider",
                "HierarchicalCollider, exact", "CombinationCollider, exact"];

        private var _random:SeededRandom;
        private var _greatLand:GreatLand;
        private var _turn:int = 0;
        private var _made:Array = [];
        private var _reference:Collider;
        private var _pair:Vector.<Agent> = new Vector.<Agent>(2, true);

        /** The name of the present one. */
        internal var name:String;

        /**
         * @param random decides
         * @param greatLand has the models
         */
        public function SoakSystems(random:SeededRandom, greatLand:GreatLand)
        {
            _random = random;
            _greatLand = greatLand;
        }

        /** The next one. */
        internal function next():Collider
        {
            var turn:int = _turn++ % NAMES.length;
            name = NAMES[turn];
            // seldom a new one: Adobe's collector takes what looks like an address for one, and from one agent of a collider that is
            // gone there is a way to all that have come since
            if (_made[turn] == null || _random.chance(0.02))
            {
                _made[turn] = make();
            }
            choose(_made[turn]);
            return _made[turn];
        }

        /** Makes one of the present kind and settings that knows of nothing yet, for colliding() to ask. */
        internal function beginReference(system:Collider):void
        {
            _reference = make();
            var precise:TreeCollider = system as TreeCollider;
            if (precise != null)
            {
                TreeCollider(_reference).exact = precise.exact;
                TreeCollider(_reference).maxDepth = precise.maxDepth;
            }
        }

        /** Whether two agents collide as they stand. */
        internal function areColliding(a:Agent, b:Agent):Boolean
        {
            if (name == "BinCollider")
            {
                _pair[0] = a;
                _pair[1] = b;
                return BruteForce.spheres(_pair).length > 0;
            }
            return _reference.areColliding(a, b);
        }

        private function make():Collider
        {
            return Collider(Colliders.make(name.split(",")[0], _greatLand));
        }

        private function choose(system:Collider):void
        {
            var precise:TreeCollider = system as TreeCollider;
            if (precise != null)
            {
                precise.exact = name.indexOf("exact") > 0;
                precise.maxDepth = _random.integer(1, 8);
            }
        }
    }
}
