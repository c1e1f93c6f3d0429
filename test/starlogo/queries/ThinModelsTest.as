package starlogo.queries
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.ThinModels;

    /** Models of points, lines, triangles and planes, in one place and on their ways: every question returns, with an answer that is right. */
    public class ThinModelsTest
    {
        private static var sGreatLand:GreatLand;

        private var _wrong:Complaints = new Complaints();
        private var _touching:int = 0;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = new GreatLand();
            ThinModels.addTo(sGreatLand);
            sGreatLand.addModel(BuiltInModel.cube());
            sGreatLand.addModel(BuiltInModel.sphere());
        }

        [Test]
        public function endsInTheTouchAndStaysThere():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var far:Number in [0, 3.3])
                {
                    eachPair(name, far);
                }
            }
            _wrong.assertNone();
            assertTrue(_touching + " touched", _touching > 100);
        }

        private function eachPair(name:String, far:Number):void
        {
            var shapes:Array = ThinModels.NAMES.concat("cube", "sphere");
            var turn:int = 0;
            for each (var first:String in shapes)
            {
                for each (var second:String in shapes)
                {
                    for (var i:int = name.indexOf("combinations") == 0 ? 0 : 3; i < 4; i++)
                    {
                        var a:Agent = new Agent(first);
                        var b:Agent = new Agent(second);
                        a.hierarchical = (i & 1) != 0;
                        b.hierarchical = (i & 2) != 0;
                        a.moveTo(far, far, 0);
                        b.moveTo(far, far, 0);
                        if (Effort.isFull || turn % 19 == 0 || first == second && i == 3)
                        {
                            comeAgain(name, a, b);
                        }
                        turn++;
                    }
                }
            }
        }

        // Onto the other's middle: it ends touching, and the same motion again does not get past it.
        private function comeAgain(name:String, a:Agent, b:Agent):void
        {
            var collider:Collider = EachCollider.make(name, sGreatLand);
            var queries:AgentQueries = new AgentQueries(collider);
            var agents:Vector.<Agent> = new <Agent>[a, b];
            b.heading = 20;
            for each (var way:Vector3D in [new Vector3D(0, 0, -1), new Vector3D(0, 1, 0), new Vector3D(0.7, -0.2, 0.5), new Vector3D(-0.1, 0.6, -0.4)])
            {
                var text:String = [name, a.shape, b.shape, b.x, way].join(", ");
                a.moveTo(b.x + 0.03 - 3 * way.x, b.y + 0.01 - 3 * way.y, b.z + (way.z == 0 ? 0.02 : 0) - 3 * way.z);
                queries.update(agents);
                if (queries.moveUntilTouch(a, 5 * way.x, 5 * way.y, 5 * way.z) == 1)
                {
                    continue;
                }
                _touching++;
                for (var i:int = 0; i < 3; i++)
                {
                    _wrong.addIf(!collider.areColliding(a, b), text, "stops at nothing");
                    queries.update(agents);
                    var part:Number = queries.moveUntilTouch(a, 5 * way.x, 5 * way.y, 5 * way.z);
                    _wrong.addIf(part > 0, text, "goes on by " + part);
                }
            }
        }
    }
}
