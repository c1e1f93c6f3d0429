package starlogo.search.penetration
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;
    import starlogo.search.StructureBody;
    import starlogo.search.SearchCounts;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.terrain.Terrain;
    import support.agentAt;
    import support.assertClose;

    /** A ball whose middle is 0.4 below the top of a wide box: the shortest push is straight up. */
    public class DirectionSearchTest
    {
        private static const RADIUS:Number = 0.1;
        private static const DEEP:Number = 0.4;

        private var _pair:DisplacedPair = new DisplacedPair(new StructurePairTests(new SearchCounts()));
        private var _search:DirectionSearch = new DirectionSearch(_pair);
        private var _out:ContactPoint = new ContactPoint();

        [Before]
        public function overlap():void
        {
            var box:Box = new Box(new Vector3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), 3, 3, 1);
            _pair.setTo(bodyOf(new Sphere(new Vector3D(0, 0, 1 - DEEP), RADIUS)), bodyOf(box), RelativeMotion.NONE);
        }

        [Test]
        public function aGuessThatIsTooShortIsMadeLongerBeforeItsDirectionIsImproved():void
        {
            for each (var guess:Number in [0, 1e-6, 0.001, 0.1, 0.45])
            {
                findAlong(0.6, 0.8, guess);
                assertIsStraightUp("" + guess);
            }
        }

        [Test]
        public function soIsOneThatIsLongEnough():void
        {
            findAlong(0.6, 0.8, 1);
            assertIsStraightUp("1");
        }

        [Test]
        public function aDirectionThatNoSideImprovesStays():void
        {
            findAlong(0, 1, 0.2);
            assertIsStraightUp("up");
            findAlong(1, 0, 0.2);
            assertClose(1, _out.normalX, 1e-12);
            assertClose(3 + RADIUS, _out.depth, 1e-8, "sideways");
        }

        // A fraction of a small body may be less than the distance between two Numbers as large as the depth.
        [Test]
        public function itEndsHoweverDeepASmallBodyIs():void
        {
            var random:SeededRandom = new SeededRandom(1127);
            for (var i:int = 0; i < 80; i++)
            {
                var cell:Number = random.logBetween(1e-3, 0.1);
                var ground:Terrain = new Terrain(8, 8, cell, -4 * cell, -4 * cell);
                setHeights(ground, random.logBetween(2e8, 9e8), i % 2 == 0 ? 0 : 0.1, random);
                var agent:Agent = agentAt("any", cell * random.between(-2, 2), cell * random.between(-2, 2), 0);
                agent.size = random.logBetween(1e-6, 3e-6);
                var depths:Array = [];
                var collision:Collision = new Collision(new BinCollider());
                collision.terrain = ground;
                collision.onCollision("turtles", Collision.TERRAIN, function(collider:Agent, collidee:Agent, contact:Contact):void
                    {
                        depths.push(contact.depth);
                    });
                collision.update(new <Agent>[agent]);
                assertEquals("contacts", 1, depths.length);
                assertTrue(depths[0] + " of " + agent.size, depths[0] > 0 && depths[0] < 1e9);
            }
        }

        private static function setHeights(ground:Terrain, height:Number, roughness:Number, random:SeededRandom):void
        {
            for (var column:int = 0; column < 8; column++)
            {
                for (var row:int = 0; row < 8; row++)
                {
                    ground.setHeight(column, row, height * (1 + roughness * random.next()));
                }
            }
        }

        private function findAlong(x:Number, z:Number, depth:Number):void
        {
            _out.setNormal(x, 0, z);
            _out.depth = depth;
            _search.findAlong(_out, _out);
        }

        private function assertIsStraightUp(said:String):void
        {
            assertClose(1, _out.normalZ, 1e-9, said + ": the normal of the top");
            assertClose(DEEP + RADIUS, _out.depth, 1e-8, said + ": the depth");
        }

        private static function bodyOf(structure:BoundingStructure):Body
        {
            return new StructureBody().setTo(structure);
        }
    }
}
