package support
{
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;

    /** Asks the colliders that visit hierarchies for a pair at every depth: none misses what is there, and no greater depth reports more. */
    public final class EveryDepth
    {
        private var _hierarchical:HierarchicalCollider;
        private var _combination:CombinationCollider;
        private var _depths:Array;

        /**
         * @param greatLand has the models
         * @param depths ascend
         */
        public function EveryDepth(greatLand:GreatLand, depths:Array)
        {
            _hierarchical = new HierarchicalCollider(greatLand);
            _combination = new CombinationCollider(greatLand);
            _depths = depths;
        }

        /**
         * Checks a pair of agents that are not hierarchical and have no depth of their own.
         *
         * @param pair its name
         * @param isHit whether the models collide
         */
        public function check(pair:String, a:Agent, b:Agent, isHit:Boolean):void
        {
            var before:Array = null;
            for each (var depth:int in _depths)
            {
                _hierarchical.maxDepth = _combination.maxDepth = depth;
                var answers:Array = ask(a, b);
                for (var way:int = 0; way < answers.length; way++)
                {
                    assertTrue(pair + ", missed at depth " + depth + ", way " + way, answers[way] || !isHit);
                    assertTrue(pair + ", more at depth " + depth + ", way " + way, before == null || before[way] || !answers[way]);
                }
                before = answers;
            }
        }

        private function ask(a:Agent, b:Agent):Array
        {
            var answers:Array = [_hierarchical.areColliding(a, b)];
            a.traversalDepth = 3;
            answers.push(_hierarchical.areColliding(a, b));
            a.traversalDepth = 0;
            b.traversalDepth = 2;
            answers.push(_hierarchical.areColliding(b, a));
            b.traversalDepth = 0;
            for (var i:int = 1; i < 4; i++)
            {
                a.hierarchical = (i & 1) != 0;
                b.hierarchical = (i & 2) != 0;
                for each (_combination.exact in [false, true])
                {
                    answers.push(_combination.areColliding(a, b));
                }
            }
            a.hierarchical = b.hierarchical = false;
            return answers;
        }
    }
}
