package starlogo.search.table
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import support.EachCollider;
    import support.agentAt;
    import support.assertThrows;

    use namespace engine;

    /** An agent that asks is seen as it is now, also if only its model has changed. */
    public class RowsOfNowTest
    {
        private var _land:GreatLand;
        private var _queries:AgentQueries;
        private var _asker:Agent;
        private var _other:Agent;

        [Test]
        public function anAskerHasItsNewModelsShape():void
        {
            for each (var name:String in EachCollider.NAMES.slice(1))
            {
                ask(name);
                assertNear(name, 1, _queries.distance(_asker, _other));
                addModel(1);
                assertEquals(name, 0, _queries.distance(_asker, _other));
                assertTrue(name, _queries.touchesAny(_asker));
                addModel(0.125);
                assertNear(name, 1.375, _queries.distance(_asker, _other));
                _queries.update(new <Agent>[_asker, _other]);
                assertNear(name + ", updated", 1.375, _queries.distance(_asker, _other));
            }
        }

        [Test]
        public function anAskersModelThatIsGoneIsMissed():void
        {
            for each (var name:String in EachCollider.NAMES.slice(1))
            {
                ask(name);
                _land.removeModel("asking");
                assertThrows(ArgumentError, /there is no model "asking"/, _queries.touching, _asker);
                _land.expect("asking");
                assertEquals("it is loading", 0, _queries.touching(_asker).length);
                addModel(1);
                assertEquals(1, _queries.touching(_asker).length);
                _land.expectNoMore("asking");
            }
        }

        private function ask(name:String):void
        {
            _land = new GreatLand();
            _land.prepareExact = true;
            addModel(0.5);
            var model:Model = box(0.5);
            _land.addModel(new Model("other", model.vertices, model.triangles, Model.AS_GIVEN));
            _asker = agentAt("asking", 0, 0, 0);
            _other = agentAt("other", 2, 0, 0);
            _asker.hierarchical = true;
            _queries = new AgentQueries(EachCollider.make(name, _land));
            _queries.update(new <Agent>[_asker, _other]);
            _queries.touching(_asker);
        }

        private function addModel(half:Number):void
        {
            _land.addModel(box(half == 1 ? 1.5 : half));
        }

        // A box from -half to half along x and y.
        private static function box(half:Number):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 8; i++)
            {
                vertices.push(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? 1 : 0);
            }
            return new Model("asking", vertices, new <uint>[0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1,
                        7, 5], Model.AS_GIVEN);
        }

        private static function assertNear(message:String, expected:Number, found:Number):void
        {
            assertTrue(message + ": " + found + ", not " + expected, Math.abs(found - expected) < 1e-9);
        }
    }
}
