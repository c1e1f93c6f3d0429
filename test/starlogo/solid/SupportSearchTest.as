package starlogo.solid
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.engine;
    import starlogo.models.ColladaModel;
    import starlogo.models.CookedModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.StructureBody;
    import starlogo.hierarchy.BoxTree;
    import starlogo.terrain.WorldBounds;
    import support.ChainOfNodes;
    import support.Effort;
    import support.Fixtures;
    import support.FurtherCapsule;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** How far trees reach towards the edges of the world. */
    public class SupportSearchTest
    {
        public static const FIXTURES:Array = ["/assets/dragon.dae", "/assets/seagull.dae"];

        // The first question prepares the triangles of a tree that was read.
        [Test]
        public function aTreeThatWasReadAnswersAtOnce():void
        {
            var asked:Object = {};
            for each (var file:String in FIXTURES)
            {
                var model:Model = new ColladaModel("model", Fixtures.text(file));
                var land:GreatLand = landOf(model);
                var cooked:Model = CookedModel.fromBytes("model", land.cook(model));
                for (var i:int = 0; i < Effort.choose(6, 60, 2); i++)
                {
                    var agent:Agent = agentAt("model", 0, 0, 0);
                    agent.heading = 200 + 31 * i;
                    agent.pitch = i % 3 == 0 ? 0 : 17 * i;
                    agent.size = 4.6 + 3 * (i & 1);
                    for each (var isDistance:Boolean in [false, true])
                    {
                        var fresh:String = ask(landOf(cooked), agent, isDistance);
                        assertEquals(file + ", " + agent.heading, ask(land, agent, isDistance), fresh);
                        assertEquals(file + ", " + agent.heading, ask(land, agent, isDistance), fresh);
                        asked[fresh] = true;
                    }
                }
            }
            var different:int = 0;
            for (fresh in asked)
            {
                different++;
            }
            assertTrue(different + " answers", different > 4);
        }

        // Deeper than recursion could go.
        [Test]
        public function treesMayBeDeep():void
        {
            var count:int = 100000;
            var shape:ModelShape = new ModelShape("chain", ModelShape.ONLY_VARIANT, 0);
            shape.setTree(new ModelTree(ChainOfNodes.read(count, count, ChainOfNodes.OF_THE_THESIS, false)));
            var body:Body = new Body();
            body.setToAgent(new Agent("chain"), shape);
            var search:SupportSearch = new SupportSearch();
            var farthest:SupportPoint = new SupportPoint();
            for each (var side:int in [-1, 1])
            {
                search.find(shape.tree.treeFor(BoxTree.LEAVES), BoxTree.LEAVES, null, body.placement, new Vector3D(side, 0, 0), farthest);
                assertTrue(farthest.support + " and " + farthest.x, Math.abs(farthest.support - (side > 0 ? count - 1 : 0)) < 1e-3);
                assertTrue(Math.abs(farthest.x - side * farthest.support) < 1e-3);
            }
        }

        [Test]
        public function aStructureReachesAsFarAsItsExtentsAndThePointIsInside():void
        {
            var structures:RandomStructures = new RandomStructures(new SeededRandom(4711));
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            var axes:Array = [Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS];
            for (var i:int = 0; i < 200; i++)
            {
                var structure:BoundingStructure = structures.ofKind(i % BoundingStructure.KIND_COUNT, 1, 3);
                structure.extentsInto(extents);
                for (var axis:int = 0; axis < 3; axis++)
                {
                    var farthest:SupportPoint = farthestOf(structure, axes[axis]);
                    var point:Vector3D = new Vector3D(farthest.x, farthest.y, farthest.z);
                    assertTrue(structure + ": " + farthest.support, Math.abs(extents[2 * axis + 1] - farthest.support) < 1e-9);
                    assertTrue(structure + ": " + point, Math.abs(point.dotProduct(axes[axis]) - farthest.support) < 1e-9);
                    assertTrue(structure + ": " + point, structure.contains(point));
                }
            }
        }

        // Rounding is then more than the tolerance for corners that are as far.
        [Test]
        public function smallStructuresFarFromTheOriginHaveAPointToo():void
        {
            var random:SeededRandom = new SeededRandom(4712);
            var structures:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 1000; i++)
            {
                var size:Number = random.logBetween(1e-3, 1);
                var spread:Number = random.logBetween(1, 1e6);
                var structure:BoundingStructure = structures.ofKind(i % BoundingStructure.KIND_COUNT, size, spread);
                var shape:ModelShape = new ModelShape("far", ModelShape.ONLY_VARIANT, 0);
                shape.setStructure(structure);
                var agent:Agent = new Agent("far");
                agent.heading = random.between(0, 360);
                agent.pitch = random.between(-90, 90);
                var body:Body = new Body();
                body.setToAgent(agent, shape);
                var direction:Vector3D = structures.direction();
                var farthest:SupportPoint = new SupportPoint();
                new SupportSearch().find(null, 1, body.shape.structure, body.placement, direction, farthest);
                var along:Number = new Vector3D(farthest.x, farthest.y, farthest.z).dotProduct(direction);
                assertTrue(structure + ": " + along + ", not " + farthest.support, Math.abs(along - farthest.support) < 1e-9 * size + 1e-12 * spread);
            }
        }

        [Test]
        public function thePointIsTheMiddleOfAFaceOrAnEdge():void
        {
            assertMiddle(new Box(new Vector3D(1, 2, 3), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 2, 3), 2, 2, 3);
            assertMiddle(new Capsule(new Vector3D(0, 1, 0), new Vector3D(0, 5, 0), 0.5), 0.5, 3, 0);
            assertMiddle(new FurtherCapsule(new Capsule(new Vector3D(0, 1, 0), new Vector3D(0, 5, 0), 0.5)), 0.5, 3, 0);
            assertMiddle(new Hull(new <Number>[0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0]), 1, 1, 0);
        }

        private static function assertMiddle(structure:BoundingStructure, x:Number, y:Number, z:Number):void
        {
            var farthest:SupportPoint = farthestOf(structure, Vector3D.X_AXIS);
            var difference:Vector3D = new Vector3D(farthest.x - x, farthest.y - y, farthest.z - z);
            assertTrue(structure + ": " + difference, difference.length < 1e-12);
        }

        private static function farthestOf(structure:BoundingStructure, direction:Vector3D):SupportPoint
        {
            var body:Body = new StructureBody().setTo(structure);
            var farthest:SupportPoint = new SupportPoint();
            new SupportSearch().find(null, 1, body.shape.structure, body.placement, direction, farthest);
            return farthest;
        }

        private static function ask(land:GreatLand, agent:Agent, isDistance:Boolean):String
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            collider.exact = true;
            var bounds:WorldBounds = new WorldBounds(-2, -3, -Infinity, 2.5, 3, 2);
            if (!isDistance)
            {
                var contact:Contact = collider.contactOf(agent, bounds.agent);
                return contact.point + " " + contact.normal + " " + contact.depth;
            }
            bounds.setTo(-50, -40, -30, 50, 40, 30);
            var point:Vector3D = new Vector3D();
            var other:Vector3D = new Vector3D();
            return new AgentQueries(collider).distance(agent, bounds.agent, point, other) + " " + point + " " + other;
        }
    }
}
